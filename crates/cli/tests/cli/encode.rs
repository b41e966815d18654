//! Meshes as files of every format, written here and not by the library, with the place of everything in them.

use std::fs;

/// A mesh as it is written: coordinates are words, indices may be wrong.
#[derive(Clone)]
pub(crate) struct Mesh {
    pub(crate) points: Vec<[String; 3]>,
    pub(crate) facets: Vec<Vec<i64>>,
    /// What a header promises, where that is not what is there.
    pub(crate) promised: [Option<u32>; 2],
}

/// The formats that a defect is written in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Kind {
    Obj,
    StlAscii,
    Stl,
    PlyAscii,
    Ply,
    PlyBig,
    ThreeMf,
}

/// A file, and where in it the vertices and the facets stand: a line or a byte.
pub(crate) struct Encoded {
    pub(crate) bytes: Vec<u8>,
    /// Of each point of the mesh; in STL, where it is mentioned first.
    pub(crate) vertices: Vec<usize>,
    pub(crate) facets: Vec<usize>,
    /// The number of each point in the file, from 0 on; in STL in the order of their first mention.
    pub(crate) numbers: Vec<usize>,
}

impl Encoded {
    fn new(bytes: Vec<u8>, vertices: Vec<usize>, facets: Vec<usize>) -> Self {
        let numbers = (0..vertices.len()).collect();
        Self { bytes, vertices, facets, numbers }
    }
}

pub(crate) const PART: &str = "3D/3dmodel.model";

impl Kind {
    pub(crate) const ALL: [Self; 7] =
        [Self::Obj, Self::StlAscii, Self::Stl, Self::PlyAscii, Self::Ply, Self::PlyBig, Self::ThreeMf];

    pub(crate) fn ending(self) -> &'static str {
        match self {
            Self::Obj => "obj",
            Self::StlAscii | Self::Stl => "stl",
            Self::PlyAscii | Self::Ply | Self::PlyBig => "ply",
            Self::ThreeMf => "3mf",
        }
    }

    /// STL and 3MF have triangles only.
    pub(crate) fn has_polygons(self) -> bool {
        !matches!(self, Self::StlAscii | Self::Stl | Self::ThreeMf)
    }

    pub(crate) fn is_binary(self) -> bool {
        matches!(self, Self::Stl | Self::Ply | Self::PlyBig)
    }

    /// How a message begins: the file, and the line or the byte in it.
    pub(crate) fn place(self, file: &str, place: Option<usize>) -> String {
        match (self, place) {
            (Self::ThreeMf, None) => format!("{file}({PART}): "),
            (Self::ThreeMf, Some(line)) => format!("{file}({PART}):{line}: "),
            (_, None) => format!("{file}: "),
            (_, Some(byte)) if self.is_binary() => format!("{file}: byte {byte}: "),
            (_, Some(line)) => format!("{file}:{line}: "),
        }
    }
}

impl Mesh {
    /// Reads an OFF file of one record a line.
    pub(crate) fn of_off(path: &str) -> Self {
        let text = fs::read_to_string(path).unwrap();
        let mut records = text.lines().skip(1).map(|line| line.split(' '));
        let counts: Vec<usize> = records.next().unwrap().map(|word| word.parse().unwrap()).collect();
        let point = |mut words: std::str::Split<'_, char>| [0; 3].map(|_| words.next().unwrap().to_string());
        let points = records.by_ref().take(counts[0]).map(point).collect();
        let cycle =
            |words: std::str::Split<'_, char>| words.skip(1).map(|word| word.parse().unwrap()).collect();
        let facets = records.map(cycle).collect();
        Self { points, facets, promised: [None; 2] }
    }

    /// The triangles of all fans.
    fn triangles(&self) -> Vec<Vec<i64>> {
        let fan = |cycle: &Vec<i64>| {
            let first = cycle[0];
            cycle[1..].windows(2).map(|pair| vec![first, pair[0], pair[1]]).collect::<Vec<_>>()
        };
        self.facets.iter().flat_map(fan).collect()
    }

    pub(crate) fn encode(&self, kind: Kind) -> Encoded {
        match kind {
            Kind::Obj => self.obj(),
            Kind::StlAscii => self.stl_ascii(),
            Kind::Stl => self.stl(),
            Kind::PlyAscii | Kind::Ply | Kind::PlyBig => self.ply(kind),
            Kind::ThreeMf => self.threemf(),
        }
    }

    fn obj(&self) -> Encoded {
        let mut text = Text::default();
        let vertices = self.points.iter().map(|point| text.line(&format!("v {}", point.join(" ")))).collect();
        let facet = |cycle: &Vec<i64>| {
            let corners: String = cycle.iter().map(|index| format!(" {}", index + 1)).collect();
            text.line(&format!("f{corners}"))
        };
        let facets = self.facets.iter().map(facet).collect();
        Encoded::new(text.bytes, vertices, facets)
    }

    fn stl_ascii(&self) -> Encoded {
        let mut text = Text::default();
        let (mut vertices, mut facets) = (Vec::new(), Vec::new());
        text.line("solid");
        for cycle in self.triangles() {
            facets.push(text.line("facet normal 0 0 0"));
            text.line("outer loop");
            for index in cycle {
                vertices.push(text.line(&format!("vertex {}", self.points[index as usize].join(" "))));
            }
            text.line("endloop");
            text.line("endfacet");
        }
        text.line("endsolid");
        self.without_indices(text.bytes, &vertices, facets)
    }

    fn stl(&self) -> Encoded {
        let triangles = self.triangles();
        let mut bytes = vec![b' '; 80];
        bytes.extend(self.promised[1].unwrap_or(triangles.len() as u32).to_le_bytes());
        let (mut vertices, mut facets) = (Vec::new(), Vec::new());
        for cycle in triangles {
            facets.push(bytes.len());
            bytes.extend([0; 12]);
            for index in cycle {
                vertices.push(bytes.len());
                let point = &self.points[index as usize];
                bytes.extend(point.iter().flat_map(|word| word.parse::<f32>().unwrap().to_le_bytes()));
            }
            bytes.extend([0; 2]);
        }
        self.without_indices(bytes, &vertices, facets)
    }

    /// What is known of a file in which each corner of each triangle has its position.
    fn without_indices(&self, bytes: Vec<u8>, corners: &[usize], facets: Vec<usize>) -> Encoded {
        let mentions = self.triangles().concat();
        let mentions: Vec<_> = mentions.iter().map(|&index| &self.points[index as usize]).collect();
        let first = |point: &[String; 3]| mentions.iter().position(|&mention| mention == point);
        let firsts: Vec<usize> = mentions.iter().map(|point| first(point).unwrap()).collect();
        let number = |at: usize| firsts[..at].iter().enumerate().filter(|&(at, &first)| at == first).count();
        let of_points: Vec<_> = self.points.iter().map(first).collect();
        let vertices = of_points.iter().map(|at| at.map_or(0, |at| corners[at])).collect();
        let numbers = of_points.iter().map(|at| at.map_or(0, number)).collect();
        Encoded { bytes, vertices, facets, numbers }
    }

    fn ply(&self, kind: Kind) -> Encoded {
        let format = match kind {
            Kind::Ply => "binary_little_endian",
            Kind::PlyBig => "binary_big_endian",
            _ => "ascii",
        };
        let number = if kind == Kind::PlyAscii { "float" } else { "double" };
        let vertices = self.promised[0].unwrap_or(self.points.len() as u32);
        let facets = self.promised[1].unwrap_or(self.facets.len() as u32);
        let mut text = Text::default();
        for line in [
            "ply",
            &format!("format {format} 1.0"),
            &format!("element vertex {vertices}"),
            &format!("property {number} x"),
            &format!("property {number} y"),
            &format!("property {number} z"),
            &format!("element face {facets}"),
            "property list uchar int vertex_indices",
            "end_header",
        ] {
            text.line(line);
        }
        if kind == Kind::PlyAscii {
            let vertices = self.points.iter().map(|point| text.line(&point.join(" "))).collect();
            let facet = |cycle: &Vec<i64>| {
                let corners: String = cycle.iter().map(|index| format!(" {index}")).collect();
                text.line(&format!("{}{corners}", cycle.len()))
            };
            let facets = self.facets.iter().map(facet).collect();
            return Encoded::new(text.bytes, vertices, facets);
        }
        let big = kind == Kind::PlyBig;
        let mut bytes = text.bytes;
        let (mut vertices, mut facets) = (Vec::new(), Vec::new());
        for point in &self.points {
            vertices.push(bytes.len());
            let doubles = point.iter().map(|word| word.parse::<f64>().unwrap());
            bytes.extend(doubles.flat_map(|x| if big { x.to_be_bytes() } else { x.to_le_bytes() }));
        }
        for cycle in &self.facets {
            facets.push(bytes.len());
            bytes.push(cycle.len() as u8);
            let indices = cycle.iter().map(|&index| index as i32);
            bytes.extend(indices.flat_map(|i| if big { i.to_be_bytes() } else { i.to_le_bytes() }));
        }
        Encoded::new(bytes, vertices, facets)
    }

    fn threemf(&self) -> Encoded {
        let mut text = Text::default();
        text.line("<model xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02'>");
        text.line("<resources><object id='1'><mesh><vertices>");
        let vertex = |[x, y, z]: &[String; 3]| text.line(&format!("<vertex x='{x}' y='{y}' z='{z}'/>"));
        let vertices = self.points.iter().map(vertex).collect();
        text.line("</vertices><triangles>");
        let triangle = |cycle: Vec<i64>| {
            text.line(&format!("<triangle v1='{}' v2='{}' v3='{}'/>", cycle[0], cycle[1], cycle[2]))
        };
        let facets = self.triangles().into_iter().map(triangle).collect();
        text.line("</triangles></mesh></object></resources>");
        text.line("<build><item objectid='1'/></build></model>");
        Encoded::new(zip(&[(PART, &text.bytes)]), vertices, facets)
    }
}

/// A text that grows by lines.
#[derive(Default)]
struct Text {
    bytes: Vec<u8>,
    lines: usize,
}

impl Text {
    /// Appends a line, and gives its number.
    fn line(&mut self, line: &str) -> usize {
        self.bytes.extend(line.as_bytes());
        self.bytes.push(b'\n');
        self.lines += 1;
        self.lines
    }
}

/// A zip archive of files that are not packed.
pub(crate) fn zip(files: &[(&str, &[u8])]) -> Vec<u8> {
    let (mut archive, mut list) = (Vec::new(), Vec::new());
    for (name, content) in files {
        let size = content.len() as u32;
        let mut header = Vec::new();
        // Version, flags, method, time, date.
        header.extend([20, 0, 0, 0, 0, 0, 0, 0, 0x21, 0]);
        header.extend([crc32(content), size, size].map(u32::to_le_bytes).concat());
        // The lengths of the name and of the extra field.
        header.extend([name.len() as u8, 0, 0, 0]);
        list.extend(b"PK\x01\x02\x14\x00");
        list.extend(&header);
        // Comment, volume, attributes, and where the file begins.
        list.extend([0; 10]);
        list.extend((archive.len() as u32).to_le_bytes());
        list.extend(name.as_bytes());
        archive.extend(b"PK\x03\x04");
        archive.extend(&header);
        archive.extend(name.as_bytes());
        archive.extend(*content);
    }
    let start = archive.len() as u32;
    archive.extend(&list);
    let count = files.len() as u8;
    archive.extend(b"PK\x05\x06\x00\x00\x00\x00");
    archive.extend([count, 0, count, 0]);
    archive.extend([list.len() as u32, start].map(u32::to_le_bytes).concat());
    archive.extend([0; 2]);
    archive
}

pub(crate) fn crc32(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| if crc & 1 == 1 { crc >> 1 ^ 0xEDB8_8320 } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), step))
}
