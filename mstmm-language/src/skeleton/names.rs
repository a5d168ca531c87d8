//! What messages and the text of a plan call the points of a network.

use crate::network::Network;

/// The names of the points of a network.
pub(super) struct Naming<'a> {
    network: &'a Network<'a>,
}

impl<'a> Naming<'a> {
    pub(super) fn of(network: &'a Network<'a>) -> Self {
        Naming { network }
    }

    /// The name of a point: its connection, or what else stands there.
    pub(super) fn point(&self, point: usize) -> String {
        if let Some(connection) = self.network.points[point].connections.first() {
            return connection.to_string();
        }
        let support = self.network.supports.iter().find(|support| support.point == point);
        let what = support.map_or_else(|| "the point".to_owned(), |support| support.support.keyword.to_string());
        let element = self.element_at(point).map(|element| join_name(&what, &element));
        element.unwrap_or(what)
    }

    /// The name of a place: that of a connection there, or of the first point.
    pub(super) fn place(&self, place: usize) -> String {
        let at = || (0..self.network.points.len()).filter(|&point| self.network.points[point].place == place);
        let named = at().find(|&point| !self.network.points[point].connections.is_empty());
        named.or_else(|| at().next()).map_or_else(String::new, |point| self.point(point))
    }

    /// The name of the node that a point belongs to: that of the rigid body there.
    pub(super) fn node(&self, point: usize) -> String {
        let body = self.network.bodies.iter().find(|body| body.points.contains(&point));
        body.map_or_else(|| self.point(point), |body| body.element.to_string())
    }

    /// The first element at a point.
    fn element_at(&self, point: usize) -> Option<String> {
        let Network { members, joints, bodies, masses, paths, .. } = self.network;
        let members = members.iter().filter(|member| member.ends.contains(&point)).map(|member| member.element);
        let joints = joints.iter().filter(|joint| joint.ends.contains(&point)).map(|joint| joint.element);
        let bodies = bodies.iter().filter(|body| body.points.contains(&point)).map(|body| body.element);
        let masses = masses.iter().filter(|mass| mass.point == point).map(|mass| mass.element);
        let paths = paths.iter().filter(|path| path.contacts.iter().any(|contact| contact.point == point));
        let paths = paths.filter_map(|path| path.elements.first()).map(|element| element.element);
        let first = members.chain(joints).chain(bodies).chain(masses).chain(paths).next();
        first.map(ToString::to_string)
    }
}

/// `pinned at beam 5`; what has the name of its point already keeps it.
pub(super) fn join_name(what: &str, point: &str) -> String {
    if point.starts_with(what) { point.to_owned() } else { format!("{what} at {point}") }
}
