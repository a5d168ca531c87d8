//! Writes what is drawn in space: supports below all, the model and its motion by depth.

use crate::depth::{at_rest, pieces};
use crate::drawing::Drawing;
use crate::figure::{Figure, Holds};
use crate::grips;
use crate::picture::{Picture, element, group, pair};
use crate::pose::Pose;
use crate::scene::Scene;
use crate::supports::Standing;
use svg::Node;

impl Picture {
    /// Draws a model in space, and its motion.
    pub(crate) fn add_in_space<M>(&mut self, drawing: &Drawing<M>, scene: &Scene) {
        let figure = &drawing.figure;
        self.add_grounds(figure, scene);
        let mut all = element("g", if drawing.motion.is_some() { "model rest" } else { "model" });
        for piece in at_rest(figure, scene) {
            let mut group = group(piece.name, piece.word);
            if let Some(at) = piece.at {
                group.assign("data-at", pair(at));
            }
            self.draw(&mut group, piece.moments.concat());
            all.append(group);
        }
        self.groups.push(all);
        self.add_pins(figure);
        let Some((motion, reach)) = &drawing.motion else { return };
        let (mut still, mut moving) = (element("g", "mode still"), element("g", "mode moving"));
        for piece in pieces(figure, scene, &Pose::moments(figure, motion, *reach)) {
            let [quiet, lively] = self.moving([piece.name, piece.word], piece.moments);
            still.append(quiet);
            moving.append(lively);
        }
        self.groups.extend([still, moving]);
    }

    /// What of supports is below the model, those that are far first.
    fn add_grounds<M>(&mut self, figure: &Figure<M>, scene: &Scene) {
        let mut all = element("g", "supports");
        let mut supports: Vec<_> = figure.supports.iter().collect();
        supports.sort_by(|one, other| scene.depths[one.anchor].total_cmp(&scene.depths[other.anchor]));
        for support in supports {
            let at = figure.anchors[support.anchor].at;
            let (ground, inks) = match support.holds {
                Holds::InSpace(grip) => (figure.sight.way(grip.ground), grips::below(grip, &figure.sight, at)),
                holds => {
                    let standing = Standing::of(figure, support.anchor, holds);
                    (standing.ground, standing.inks(holds))
                }
            };
            let mut group = group(&support.name, support.holds.symbol());
            group.assign("data-at", pair(at));
            group.assign("data-ground", pair(ground));
            self.draw(&mut group, inks);
            all.append(group);
        }
        self.groups.push(all);
    }

    /// What of supports is above the model.
    fn add_pins<M>(&mut self, figure: &Figure<M>) {
        let mut all = element("g", "pins");
        for support in &figure.supports {
            if let Holds::InSpace(grip) = support.holds {
                let mut group = group(&support.name, support.holds.symbol());
                self.draw(&mut group, grips::above(grip, figure.anchors[support.anchor].at));
                all.append(group);
            }
        }
        self.groups.push(all);
    }
}
