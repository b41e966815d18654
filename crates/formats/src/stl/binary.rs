//! Binary STL, read exactly.
//!
//! A header of 80 bytes, the number of facets, and for each facet 50 bytes: its normal and three corners, each of
//! three 32-bit floats, and two bytes of attributes. All numbers are little-endian.

use super::weld::Welder;
use super::{add_facet, note_dropped};
use crate::base::budget::Budget;
use crate::base::error::{At, Fault, Located, NumberFault};
use crate::base::maker::MeshMaker;
use crate::base::model::ReadModel;
use crate::base::places::{Place, PlaceList};
use crate::base::scan::Token;
use crate::format::Format;
use exact::Point3;

/// Where the number of facets stands.
const COUNT: usize = 80;
/// Where the facets begin.
const FACETS: usize = 84;
/// The size of a facet.
const FACET: usize = 50;
/// Where in a facet the first corner stands, behind the normal.
const CORNERS: usize = 12;
/// The size of a corner.
const CORNER: usize = 12;

/// What the header promises: the number of facets, and the length of the file. `None` if there is no header.
pub(super) fn promised(bytes: &[u8]) -> Option<(u32, u64)> {
    let count = bytes.get(COUNT..FACETS)?.try_into().expect("the count has four bytes");
    let count = u32::from_le_bytes(count);
    Some((count, FACETS as u64 + FACET as u64 * u64::from(count)))
}

/// Whether no corner of the facets that are there is infinite or not a number.
pub(super) fn corners_are_finite(bytes: &[u8]) -> bool {
    bytes[FACETS.min(bytes.len())..].as_chunks::<FACET>().0.iter().all(|facet| {
        (0..3).all(|corner| corner_bits(facet, corner).iter().all(|&bits| f32::from_bits(bits).is_finite()))
    })
}

/// Whether no facet of those that are there has attributes.
pub(super) fn attributes_are_zero(bytes: &[u8]) -> bool {
    bytes[FACETS.min(bytes.len())..].as_chunks::<FACET>().0.iter().all(|facet| facet.ends_with(&[0, 0]))
}

/// Reads binary STL. Corners at the same position are one vertex, in the order of their first mention.
pub(super) fn read(bytes: &[u8], budget: &mut Budget) -> Result<ReadModel, Located> {
    let length = bytes.len() as u64;
    let Some((count, promised)) = promised(bytes) else {
        let expected = "the header of binary STL was expected: 80 bytes, and the number of facets".into();
        return Err(Fault::Truncated { expected }.at(Place::Byte(length)));
    };
    if count == 0 {
        return Err(Fault::NoVertices.at(Place::Byte(COUNT as u64)));
    }
    let (facets, _) = bytes[FACETS..].as_chunks::<FACET>();
    if length < promised {
        let read = facets.len();
        let expected = format!("a facet was expected, after {read} of the {count} that the header promises");
        return Err(Fault::Truncated { expected }.at(Place::Byte(length)));
    }
    if length > promised {
        // The file is longer than what is promised, so that this fits.
        let rest = &bytes[promised as usize..];
        let token = Token { bytes: &rest[..rest.len().min(8)], line: 1 }.shown();
        let noun = if count == 1 { "facet" } else { "facets" };
        let end = format!("the mesh, whose header promises {count} {noun}");
        return Err(Fault::AfterEnd { token, end }.at(Place::Byte(promised)));
    }
    read_facets(facets, budget)
}

fn read_facets(facets: &[[u8; FACET]], budget: &mut Budget) -> Result<ReadModel, Located> {
    // A closed surface has half as many vertices as triangles.
    let mut welder = Welder::new(facets.len() / 2, budget)?;
    let places = PlaceList::stride(FACETS as u64, FACET as u64);
    let mut maker = MeshMaker::new(budget, PlaceList::bytes(), places);
    let mut dropped = 0;
    let mut first = FACETS as u64;
    for facet in facets {
        let mut cycle = [0; 3];
        for (corner, index) in cycle.iter_mut().enumerate() {
            let bits = corner_bits(facet, corner).map(without_sign_of_zero);
            *index = match welder.find(&bits) {
                Ok(index) => index,
                Err(free) => {
                    let place = first + (CORNERS + CORNER * corner) as u64;
                    let index = add_vertex(&mut maker, bits, place)?;
                    welder.enter(free, bits, index, maker.budget()).at_byte(place)?;
                    index
                }
            };
        }
        if !add_facet(&mut maker, cycle, Place::Byte(first)).at_byte(first)? {
            if dropped == 0 {
                // From here on the places of the facets are kept one by one.
                let before = 16 * (u64::from(maker.facet_count()) + 1);
                maker.budget().charge(before).at_byte(first)?;
            }
            dropped += 1;
        }
        first += FACET as u64;
    }
    note_dropped(&mut maker, dropped);
    maker.read_model(Format::Stl)
}

#[inline]
fn corner_bits(facet: &[u8; FACET], corner: usize) -> [u32; 3] {
    [0, 1, 2].map(|axis| {
        let at = CORNERS + CORNER * corner + 4 * axis;
        u32::from_le_bytes([facet[at], facet[at + 1], facet[at + 2], facet[at + 3]])
    })
}

#[inline]
fn without_sign_of_zero(bits: u32) -> u32 {
    if bits << 1 == 0 { 0 } else { bits }
}

#[inline]
fn add_vertex(maker: &mut MeshMaker<'_>, bits: [u32; 3], place: u64) -> Result<u32, Located> {
    match Point3::from_f64s(bits.map(|bits| f64::from(f32::from_bits(bits)))) {
        Some(point) => maker.vertex(point, Place::Byte(place)).at_byte(place),
        None => Err(not_finite(bits, place)),
    }
}

#[cold]
fn not_finite(bits: [u32; 3], place: u64) -> Located {
    let floats = bits.map(f32::from_bits);
    let axis = floats.iter().position(|float| !float.is_finite()).unwrap_or(0);
    let fault = Fault::BadNumber { token: floats[axis].to_string(), fault: NumberFault::NotFinite };
    fault.at(Place::Byte(place + 4 * axis as u64))
}
