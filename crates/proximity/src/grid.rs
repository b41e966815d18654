//! Where a walk over the facets of M begins.

/// For the directions of a grid on the six sides of a cube, the facets that rays from the center stab: a guess for any direction.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    center: [f64; 3],
    /// How far from the center the guesses are made.
    radius: f64,
    resolution: usize,
    facets: Vec<u32>,
}

impl Grid {
    /// Asks `stab` for about so many directions, at points, each from the answer for a neighbour.
    pub(crate) fn new(
        center: [f64; 3],
        radius: f64,
        count: usize,
        mut stab: impl FnMut([f64; 3], u32) -> u32,
    ) -> Self {
        let resolution = ((count as f64 / 6.0).sqrt().ceil() as usize).clamp(1, 512);
        let mut grid = Self { center, radius, resolution, facets: vec![0; 6 * resolution * resolution] };
        let mut last = 0;
        for side in 0..6 {
            for i in 0..resolution {
                for j in 0..resolution {
                    // Back and forth, so that the last cell is a neighbour.
                    let j = if i.is_multiple_of(2) { j } else { resolution - 1 - j };
                    last = stab(grid.point(side, i, j), last);
                    grid.facets[(side * resolution + i) * resolution + j] = last;
                }
            }
        }
        grid
    }

    /// The middle of a cell.
    fn point(&self, side: usize, i: usize, j: usize) -> [f64; 3] {
        let middle = |i: usize| (2 * i + 1) as f64 / self.resolution as f64 - 1.0;
        let mut point = self.center;
        let axis = side / 2;
        point[axis] += if side.is_multiple_of(2) { self.radius } else { -self.radius };
        point[(axis + 1) % 3] += middle(i) * self.radius;
        point[(axis + 2) % 3] += middle(j) * self.radius;
        point
    }

    /// A facet that is stabbed near a point.
    #[inline]
    pub(crate) fn guess(&self, point: [f64; 3]) -> u32 {
        let d = [0, 1, 2].map(|i: usize| point[i] - self.center[i]);
        self.guess_direction(d)
    }

    /// A facet that is stabbed near a ray.
    #[inline]
    pub(crate) fn guess_direction(&self, d: [f64; 3]) -> u32 {
        let [x, y, z] = d.map(f64::abs);
        let axis = if x >= y && x >= z { 0 } else { 1 + usize::from(z > y) };
        let side = 2 * axis + usize::from(d[axis] < 0.0);
        let scale = 0.5 / d[axis].abs();
        let cell = |value: f64| {
            // Casts saturate, and what is not a number becomes zero.
            (((value * scale + 0.5) * self.resolution as f64) as usize).min(self.resolution - 1)
        };
        let (i, j) = (cell(d[(axis + 1) % 3]), cell(d[(axis + 2) % 3]));
        self.facets[(side * self.resolution + i) * self.resolution + j]
    }
}
