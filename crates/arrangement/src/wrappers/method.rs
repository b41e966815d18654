//! Names of the methods of all traits.

use std::fmt;

macro_rules! methods {
    ($($variant:ident $name:ident,)*) => {
        /// A method of the geometry traits, by its name.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        #[non_exhaustive]
        pub enum Method {
            $(
                #[doc = concat!("`", stringify!($name), "`")]
                $variant,
            )*
        }

        impl Method {
            /// All methods, those of the basic traits first.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// The name, as it stands in the trait.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => stringify!($name),)*
                }
            }
        }
    };
}

methods! {
    CompareU compare_u,
    OrderKey order_key,
    OrderRange order_range,
    SideKey side_key,
    CompareVAtUByKey compare_v_at_u_by_key,
    CompareUv compare_uv,
    IsCanonical is_canonical,
    IsOwnCurve is_own_curve,
    EndPoint end_point,
    IsVertical is_vertical,
    CompareVAtU compare_v_at_u,
    CompareVAtURight compare_v_at_u_right,
    CompareVAtULeft compare_v_at_u_left,
    IsSamePoint is_same_point,
    IsInURange is_in_u_range,
    IsOnCurve is_on_curve,
    Intersect intersect,
    Split split,
    Merge merge,
    IsMergeable is_mergeable,
    NextMeeting next_meeting,
    EndOfOverlap end_of_overlap,
    Trim trim,
    MakeUMonotone make_u_monotone,
    IsDirectedRight is_directed_right,
    Opposite opposite,
    Source source,
    Target target,
    ApproxPoint approx_point,
    ApproxCurve approx_curve,
    ApproxToPoint approx_to_point,
    EndLocation end_location,
    CompareVNearSide compare_v_near_side,
    CompareUNearEnd compare_u_near_end,
    CompareUOfEnds compare_u_of_ends,
    ContractionBottomTop contraction_bottom_top,
    ContractedBottomTop contracted_bottom_top,
    IsOnLeftRight is_on_left_right,
    CompareVOnLeftRight compare_v_on_left_right,
    IsOnBottomTop is_on_bottom_top,
    CompareUOnBottomTop compare_u_on_bottom_top,
    IsJointAllowed is_joint_allowed,
    IsFoldbackOnSide is_foldback_on_side,
    CompareUToEnd compare_u_to_end,
    Direction direction,
    Connect connect,
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
