//! Numbers and path data. All coordinates are integers here: numbers of units of the last decimal.

/// A decimal, in its shortest form: `12`, `-.5`, `3.25`.
pub(super) fn push_number(out: &mut String, units: i64, decimals: u32) {
    let one = 10_u64.pow(decimals);
    let size = units.unsigned_abs();
    let (whole, mut rest) = (size / one, size % one);
    if units < 0 {
        out.push('-');
    }
    if whole > 0 || rest == 0 {
        push_digits(out, whole, 1);
    }
    if rest > 0 {
        let mut width = decimals as usize;
        while rest % 10 == 0 {
            rest /= 10;
            width -= 1;
        }
        out.push('.');
        push_digits(out, rest, width);
    }
}

/// The digits of a number, with zeros in front up to `width`.
fn push_digits(out: &mut String, mut value: u64, width: usize) {
    let mut digits = [b'0'; 20];
    let mut start = digits.len();
    while value > 0 || digits.len() - start < width {
        start -= 1;
        digits[start] = b'0' + (value % 10) as u8;
        value /= 10;
    }
    out.extend(digits[start..].iter().map(|&digit| char::from(digit)));
}

/// The `d` attribute of a path, being written.
pub(super) struct PathData<'a> {
    out: &'a mut String,
    decimals: u32,
    /// Command that another pair of numbers would continue.
    command: char,
}

impl<'a> PathData<'a> {
    pub(super) fn new(out: &'a mut String, decimals: u32) -> Self {
        Self { out, decimals, command: ' ' }
    }

    /// A chain through the points: absolute at its begin, relative from there; steps without length are left out.
    ///
    /// A chain without any step is a dot, which round ends make visible.
    pub(super) fn chain(&mut self, points: impl IntoIterator<Item = [i64; 2]>, closed: bool) {
        let mut points = points.into_iter();
        let Some(first) = points.next() else { return };
        self.command = ' ';
        self.write('M', &first);
        let (mut at, mut pending) = (first, None);
        let mut steps = 0_usize;
        for point in points {
            if point == at {
                continue;
            }
            if let Some(step) = pending.replace([point[0] - at[0], point[1] - at[1]]) {
                self.step(step);
            }
            steps += 1;
            at = point;
        }
        if let Some(last) = pending {
            // The last step back to the begin is what `z` does.
            if !(closed && at == first && steps > 1) {
                self.step(last);
            }
        } else if !closed {
            self.write('h', &[0]);
        }
        if closed {
            self.out.push('z');
        }
    }

    fn step(&mut self, [dx, dy]: [i64; 2]) {
        match (dx, dy) {
            (_, 0) => self.write('h', &[dx]),
            (0, _) => self.write('v', &[dy]),
            _ => self.write('l', &[dx, dy]),
        }
    }

    fn write(&mut self, command: char, numbers: &[i64]) {
        let mut is_after_letter = self.command != command;
        if is_after_letter {
            self.out.push(command);
            self.command = command;
        }
        for &number in numbers {
            if !is_after_letter && number >= 0 {
                self.out.push(' ');
            }
            push_number(self.out, number, self.decimals);
            is_after_letter = false;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(units: i64, decimals: u32) -> String {
        let mut out = String::new();
        push_number(&mut out, units, decimals);
        out
    }

    fn chain(points: &[[i64; 2]], closed: bool) -> String {
        let mut out = String::new();
        PathData::new(&mut out, 1).chain(points.iter().copied(), closed);
        out
    }

    #[test]
    fn numbers_are_short() {
        let rows = [
            (0, 3, "0"),
            (5, 3, ".005"),
            (-500, 3, "-.5"),
            (12_000, 3, "12"),
            (-3250, 3, "-3.25"),
            (7, 0, "7"),
            (100_010, 4, "10.001"),
        ];
        for (units, decimals, text) in rows {
            assert_eq!(number(units, decimals), text);
        }
        assert_eq!(number(i64::MIN, 6), "-9223372036854.775808");
    }

    #[test]
    fn chains_are_short() {
        assert_eq!(chain(&[], true), "");
        assert_eq!(chain(&[[15, 0]], false), "M1.5 0h0");
        assert_eq!(chain(&[[10, 0], [10, 0]], true), "M1 0z");
        assert_eq!(chain(&[[0, 0], [10, 0], [10, 10], [0, 0]], true), "M0 0h1v1z");
        assert_eq!(chain(&[[0, 0], [10, -20], [5, 20], [5, 30]], false), "M0 0l1-2-.5 4v1");
        assert_eq!(chain(&[[0, 0], [10, 0], [0, 0]], false), "M0 0h1-1");
    }
}
