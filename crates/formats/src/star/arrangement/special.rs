//! The vertices that stand for sides of the parameter space. They come before all others.

use dcel::VertexId;

/// How many there are, and which records they have.
#[derive(Clone, Copy, Debug)]
pub(super) enum Special {
    Nothing,
    /// One at infinity, which has no record.
    Infinity,
    /// The poles, the south pole first, each with the position of its record among those of vertices. They have one if something is there.
    Poles([Option<usize>; 2]),
}

impl Special {
    pub(super) fn count(self) -> usize {
        match self {
            Self::Nothing => 0,
            Self::Infinity => 1,
            Self::Poles(_) => 2,
        }
    }

    pub(super) fn is_infinity(self) -> bool {
        matches!(self, Self::Infinity)
    }

    /// Gives a vertex that stands for a side the next record.
    pub(super) fn declare(&mut self, v: VertexId, record: usize) {
        if let Self::Poles(records) = self {
            records[v.index()] = Some(record);
        }
    }

    /// The vertex of a record.
    pub(super) fn vertex(self, record: usize) -> VertexId {
        let Self::Poles(poles) = self else { return VertexId::new(record + self.count()) };
        let pole = poles.iter().position(|&pole| pole == Some(record));
        let before = poles.iter().flatten().filter(|&&pole| pole < record).count();
        VertexId::new(pole.unwrap_or(record + self.count() - before))
    }

    /// The record of a vertex.
    pub(super) fn record(self, v: VertexId) -> Option<usize> {
        let ordinary = v.index().checked_sub(self.count());
        let Self::Poles(mut poles) = self else { return ordinary };
        let Some(mut record) = ordinary else { return poles[v.index()] };
        poles.sort_unstable();
        // Those of poles are passed.
        for pole in poles.into_iter().flatten() {
            record += usize::from(pole <= record);
        }
        Some(record)
    }

    /// A vertex without a record, as messages name it.
    pub(super) fn name(self, v: VertexId) -> &'static str {
        match self {
            Self::Poles(_) => ["the south pole", "the north pole"][v.index() & 1],
            _ => "infinity",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_and_vertices_are_inverse() {
        let records = [None, Some(0), Some(1), Some(3)];
        let poles = records.iter().flat_map(|&s| records.iter().map(move |&n| [s, n]));
        let poles = poles.filter(|[s, n]| s.is_none() || s != n).map(Special::Poles);
        for special in [Special::Nothing, Special::Infinity].into_iter().chain(poles) {
            let mut seen: Vec<VertexId> = (0..6).map(|record| special.vertex(record)).collect();
            for (record, &v) in seen.iter().enumerate() {
                assert_eq!(special.record(v), Some(record), "{special:?}");
            }
            seen.sort_unstable();
            let ordinary = seen.iter().filter(|v| v.index() >= special.count());
            assert!(ordinary.enumerate().all(|(i, v)| v.index() == i + special.count()), "{special:?}");
        }
    }

    #[test]
    fn what_has_no_record_has_a_name() {
        assert_eq!(Special::Infinity.record(VertexId(0)), None);
        assert_eq!(Special::Infinity.name(VertexId(0)), "infinity");
        let mut poles = Special::Poles([None; 2]);
        poles.declare(VertexId(1), 4);
        assert_eq!([0, 1].map(|v| poles.record(VertexId(v))), [None, Some(4)]);
        assert_eq!(poles.name(VertexId(0)), "the south pole");
    }
}
