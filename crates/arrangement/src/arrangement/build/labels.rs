//! Pieces of faces that are found to be one.

/// A union-find structure over the gaps of the status line.
#[derive(Debug)]
pub(super) struct Labels {
    parents: Vec<u32>,
}

impl Labels {
    pub(super) fn new() -> Self {
        Self { parents: Vec::new() }
    }

    /// A label for a gap that has just opened.
    #[inline]
    pub(super) fn fresh(&mut self) -> u32 {
        let label = self.parents.len() as u32;
        assert!(label < super::WRAP, "fewer than 2^31 gaps open");
        self.parents.push(label);
        label
    }

    /// Two gaps belong to one face.
    pub(super) fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.find(a), self.find(b));
        // The older label stays, so that the first gap of all names its face.
        let (kept, gone) = if a < b { (a, b) } else { (b, a) };
        self.parents[gone as usize] = kept;
    }

    fn find(&mut self, mut label: u32) -> u32 {
        while self.parents[label as usize] != label {
            let grandparent = self.parents[self.parents[label as usize] as usize];
            self.parents[label as usize] = grandparent;
            label = grandparent;
        }
        label
    }

    /// Numbers the faces in the order of their oldest labels, and gives the face of each label and their number.
    pub(super) fn into_faces(mut self) -> (Vec<u32>, usize) {
        let mut count = 0;
        for label in 0..self.parents.len() {
            // A parent is older, and has its number already.
            self.parents[label] = match self.parents[label] {
                parent if parent as usize == label => {
                    count += 1;
                    count - 1
                }
                parent => self.parents[parent as usize],
            };
        }
        (self.parents, count as usize)
    }
}
