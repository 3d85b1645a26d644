#!/usr/bin/env python3
"""Judges models of Technic parts: python3 score.py --parts parts.json MODEL...

Python's standard library alone. It shares no code with Liftarm: the rules are those of docs/dataset/README.md, the solids are
compared by alternating projections. What it does not judge is said there too: taking apart and turning joints.

MODEL is a model file (docs/dataset/README.md, "Result format"); parts.json is what `liftarm parts` prints. For each model one
line of JSON: {"file", "valid", "items": {"realParts": n, ...}, "beams", "bricks", "gaps"?, "problems": [...]}, n being
the number of problems of an item. Exit code 0: all are valid; 2: some are not; 1: a file cannot be read.
"""
import argparse
import json
import math
import sys

# Tolerances, in modules of 8 mm (docs/dataset/README.md, "Rules").
PENETRATION = 0.03
COAXIAL_COSINE = 0.99985
COAXIAL_DISTANCE = 0.06
PLAY = 0.02
RIM_DEPTH = 0.1
HEAD_RADIUS = 0.3
TOOTH_TIPS = 0.25
GROUND = 0.05
OFF_LINE = 0.06
PARALLEL = 0.9998
MOST_LAYERS = 3
BRIDGE = 3.0
SAME_NODE = 0.01
ROTATION = 1e-4
MALE = ("pin", "axle")


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def mul(s, a):
    return (s * a[0], s * a[1], s * a[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def turned(rotation, p):
    return tuple(rotation[3 * i] * p[0] + rotation[3 * i + 1] * p[1] + rotation[3 * i + 2] * p[2] for i in range(3))


class Groups:
    """Disjoint sets."""

    def __init__(self, count):
        self.parent = list(range(count))

    def find(self, i):
        while self.parent[i] != i:
            self.parent[i] = self.parent[self.parent[i]]
            i = self.parent[i]
        return i

    def join(self, a, b):
        self.parent[self.find(a)] = self.find(b)


class Solid:
    """All points within `radius` of a segment, across an axis, and within `half` along it."""

    def __init__(self, start, end, axis, radius, half, kind, head=None):
        self.start, self.end, self.axis = start, end, axis
        self.radius, self.half, self.kind, self.head = radius, half, kind, head
        self.low, self.high = self.bounds()

    def bounds(self):
        low, high = [], []
        for i in range(3):
            a = self.axis[i]
            reach = self.radius * math.sqrt(max(0.0, 1.0 - a * a)) + self.half * abs(a)
            low.append(min(self.start[i], self.end[i]) - reach)
            high.append(max(self.start[i], self.end[i]) + reach)
        return low, high

    def nearest(self, p, inset):
        """The point of the solid, drawn in by `inset`, that is nearest to p."""
        offset = sub(p, self.start)
        along = dot(offset, self.axis)
        flat = sub(offset, mul(along, self.axis))
        segment = sub(self.end, self.start)
        square = dot(segment, segment)
        t = min(1.0, max(0.0, dot(flat, segment) / square)) if square > 1e-12 else 0.0
        foot = mul(t, segment)
        out = sub(flat, foot)
        distance = length(out)
        radius = self.radius - inset
        if distance > radius:
            out = mul(radius / distance, out)
        height = min(self.half - inset, max(inset - self.half, along))
        return add(add(self.start, foot), add(out, mul(height, self.axis)))

    def furthest(self, d, inset):
        """How far the solid reaches along d."""
        along = dot(d, self.axis)
        across = math.sqrt(max(0.0, dot(d, d) - along * along))
        ends = max(dot(d, self.start), dot(d, self.end))
        return ends + (self.radius - inset) * across + (self.half - inset) * abs(along)


class Block:
    """A box along the axes."""

    def __init__(self, low, high):
        self.low, self.high = low, high

    def nearest(self, p, inset):
        return tuple(min(self.high[i] - inset, max(self.low[i] + inset, p[i])) for i in range(3))

    def furthest(self, d, inset):
        return sum(d[i] * (self.high[i] - inset if d[i] > 0 else self.low[i] + inset) for i in range(3))


def boxes_meet(a, b, tolerance):
    return all(a.low[i] + tolerance < b.high[i] and b.low[i] + tolerance < a.high[i] for i in range(3))


def enter(a, b, tolerance):
    """Whether two convex solids enter each other by more than the tolerance: projections to and fro end in a common
    point, or at the two nearest points, between which a plane parts the solids."""
    if not boxes_meet(a, b, tolerance):
        return False
    inset = tolerance / 2
    p = tuple((a.low[i] + a.high[i] + b.low[i] + b.high[i]) / 4 for i in range(3))
    for _ in range(2000):
        q = a.nearest(p, inset)
        p = b.nearest(q, inset)
        d = sub(p, q)
        if dot(d, d) < 1e-18:
            return True
        if a.furthest(d, inset) + b.furthest(mul(-1.0, d), inset) < 0.0:
            return False
    return True  # they touch to within rounding


class Slot:
    """One module of a hole or head, in the world."""

    def __init__(self, part, feature, number, facts, placed):
        self.part, self.feature, self.number = part, feature, number
        self.kind = facts["kind"]
        self.length = facts["length"] / len(facts["slots"])
        self.at = placed.point(facts["slots"][number])
        self.axis = placed.direction(facts["axis"])
        self.wing = placed.direction(facts["wing"]) if facts.get("wing") else (0.0, 0.0, 0.0)


class Placed:
    """A part in its place."""

    def __init__(self, index, source, facts):
        self.index, self.id, self.facts = index, source["part"], facts
        self.position = tuple(source["position"])
        self.rotation = source["rotation"]
        self.layer = source.get("layer", 0)
        self.solids, self.slots = [], []
        if facts is None:
            return
        for kind in ("solid", "collars"):
            for s in facts.get(kind, []):
                self.solids.append(self.solid(s["from"], s["to"], s["axis"], s["radius"], s["halfThickness"], kind))
        for f, feature in enumerate(facts["features"]):
            for n in range(len(feature["slots"])):
                slot = Slot(index, f, n, feature, self)
                self.slots.append(slot)
                if slot.kind in MALE:
                    at = feature["slots"][n]
                    self.solids.append(self.solid(at, at, feature["axis"], HEAD_RADIUS, slot.length / 2, "head", (f, n)))

    def solid(self, start, end, axis, radius, half, kind, head=None):
        return Solid(self.point(start), self.point(end), self.direction(axis), radius, half, kind, head)

    def point(self, p):
        return add(self.position, turned(self.rotation, p))

    def direction(self, d):
        return turned(self.rotation, d)

    @property
    def is_beam(self):
        return self.facts is not None and self.facts["class"] == "beam"

    def is_real(self):
        x, y, z = (tuple(self.rotation[3 * i + j] for i in range(3)) for j in range(3))
        return (abs(dot(x, x) - 1) < ROTATION and abs(dot(y, y) - 1) < ROTATION and abs(dot(x, y)) < ROTATION
                and length(sub(cross(x, y), z)) < ROTATION)


class Joint:
    """A head in a hole. `fit`: turn, slide, rigid; or what is wrong: twisted, wrong kind, misplaced."""

    def __init__(self, male, female, fit):
        self.male, self.female, self.fit = male, female, fit

    @property
    def good(self):
        return self.fit in ("turn", "slide", "rigid")

    @property
    def holds(self):
        return self.fit != "slide"


def fit_of(male, female):
    """How a head and a hole go together; None where they have nothing to do with each other."""
    if abs(dot(male.axis, female.axis)) < COAXIAL_COSINE:
        return None
    offset = sub(male.at, female.at)
    along = dot(offset, female.axis)
    aside = length(sub(offset, mul(along, female.axis)))
    apart = abs(along)
    if aside > COAXIAL_DISTANCE or apart >= (male.length + female.length) / 2 - COAXIAL_DISTANCE:
        return None
    room = max(0.0, (male.length - female.length) / 2)
    if female.length > 0.6:
        seated = apart <= COAXIAL_DISTANCE
    elif male.kind == "axle":
        seated = apart <= room + COAXIAL_DISTANCE
    else:  # a thin beam lies at one end of a pin's slot
        seated = abs(apart - room) <= COAXIAL_DISTANCE
    if aside > PLAY or not seated:
        return "misplaced"
    if male.kind == "pin":
        return "turn" if female.kind == "pinHole" else "wrong kind"
    if female.kind == "pinHole":
        return "slide"
    c, s = abs(dot(male.wing, female.wing)), length(cross(male.wing, female.wing))
    return "rigid" if min(c, s) <= 0.035 else "twisted"


def find_joints(parts):
    grid = {}
    for part in parts:
        for slot in part.slots:
            if slot.kind not in MALE:
                grid.setdefault(tuple(math.floor(x) for x in slot.at), []).append(slot)
    joints = []
    for part in parts:
        for male in part.slots:
            if male.kind not in MALE:
                continue
            base = [math.floor(x) for x in male.at]
            for x in range(base[0] - 1, base[0] + 2):
                for y in range(base[1] - 1, base[1] + 2):
                    for z in range(base[2] - 1, base[2] + 2):
                        for female in grid.get((x, y, z), ()):
                            fit = fit_of(male, female) if female.part != male.part else None
                            if fit is not None:
                                joints.append(Joint(male, female, fit))
    hold_between_stops(parts, joints)
    return joints


def hold_between_stops(parts, joints):
    """Beams on an axle cannot slide where they fill the room between two stops."""
    heads = {}
    for joint in joints:
        feature = parts[joint.male.part].facts["features"][joint.male.feature]
        if feature["kind"] == "axle" and len(feature["slots"]) > 1:
            heads.setdefault((joint.male.part, joint.male.feature), []).append(joint)
    for (part, number), on_it in heads.items():
        facts = parts[part].facts
        feature = facts["features"][number]
        places = ["empty"] * (len(feature["slots"]) + 2)
        for joint in on_it:
            if joint.fit == "rigid":
                places[joint.male.number + 1] = "stop"
            elif places[joint.male.number + 1] == "empty":
                places[joint.male.number + 1] = "beam"
        inward = sub(feature["slots"][-1], feature["slots"][0])
        for collar in facts.get("collars", []):
            before = dot(sub(collar["from"], feature["center"]), inward) < 0
            places[0 if before else -1] = "stop"
        for joint in on_it:
            low = high = joint.male.number + 1
            while low > 0 and places[low] == "beam":
                low -= 1
            while high + 1 < len(places) and places[high] == "beam":
                high += 1
            if joint.fit == "slide" and places[low] == places[high] == "stop":
                joint.held = True
    for joint in joints:
        if getattr(joint, "held", False):
            joint.fit = "turn"


class Space:
    """Rule 2: who takes whose place."""

    def __init__(self, parts, joints):
        self.parts = parts
        self.seated = {(j.male.part, (j.male.feature, j.male.number), j.female.part) for j in joints}
        self.bad = {(j.male.part, j.female.part) for j in joints if not j.good}
        self.holes = {}
        for j in joints:
            self.holes.setdefault(j.male.part, set()).add((j.female.part, j.female.feature, j.female.number))

    def problems(self):
        order = sorted((p for p in self.parts if p.solids), key=lambda p: min(s.low[0] for s in p.solids))
        reach = {p.index: max(s.high[0] for s in p.solids) for p in order}
        active, found = [], []
        for part in order:
            left = min(s.low[0] for s in part.solids)
            active = [other for other in active if reach[other.index] > left]
            found += [("collision", [o.index, part.index]) for o in active if self.collide(o, part)]
            active.append(part)
        return found

    def collide(self, a, b):
        gears = a.facts["class"] == "gear" and b.facts["class"] == "gear"
        tolerance = PENETRATION + (TOOTH_TIPS if gears else 0.0)
        return any(enter(s, t, tolerance) and not self.excused(a, s, b, t)
                   for s in a.solids for t in b.solids if boxes_meet(s, t, tolerance))

    def excused(self, a, s, b, t):
        if s.kind != "solid" and t.kind != "solid" and self.holes.get(a.index, set()) & self.holes.get(b.index, set()):
            return True  # two heads in one hole: told by rule 3
        return self.let_off(a, s, b) or self.let_off(b, t, a)

    def let_off(self, part, solid, other):
        if solid.kind == "head":
            return (part.index, solid.head, other.index) in self.seated
        return solid.kind == "collars" and ((part.index, other.index) in self.bad or self.in_rim(solid, other))

    @staticmethod
    def in_rim(collar, other):
        for slot in other.slots:
            if slot.kind != "pinHole" or abs(dot(collar.axis, slot.axis)) < COAXIAL_COSINE:
                continue
            offset = sub(collar.start, slot.at)
            along = dot(offset, slot.axis)
            aside = length(sub(offset, mul(along, slot.axis)))
            depth = slot.length / 2 - (abs(along) - collar.half)
            if aside <= COAXIAL_DISTANCE and depth <= RIM_DEPTH + PENETRATION:
                return True
        return False


def forbidden_places(parts, sketch):
    found = []
    blocks = [Block([math.ceil(x - 1e-6) - 0.5 for x in box["min"]], [math.floor(x + 1e-6) + 0.5 for x in box["max"]])
              for box in sketch.get("keepOut", [])]
    ground = sketch.get("ground")
    for part in parts:
        found += [("keepOut", [part.index]) for block in blocks if any(enter(s, block, PENETRATION) for s in part.solids)]
        if ground is not None and any(min(s.start[2], s.end[2]) < ground - GROUND for s in part.solids):
            found.append(("ground", [part.index]))
    return found


def connection_problems(parts, joints):
    """Rule 3."""
    found = [("badFit", list(pair)) for pair in {(j.male.part, j.female.part) for j in joints if not j.good}]
    holes = {}
    for j in joints:
        holes.setdefault((j.female.part, j.female.feature, j.female.number), []).append(j.male.part)
    found += [("sharedHole", [hole[0], *heads]) for hole, heads in holes.items() if len(heads) > 1]
    touched = {i for j in joints for i in (j.male.part, j.female.part)}
    held = {i for j in joints if j.holds for i in (j.male.part, j.female.part)}
    for part in parts:
        if part.facts is None or part.index in held or len(parts) < 2:
            continue
        if part.index in touched:
            found.append(("loose", [part.index]))
        elif not part.is_beam:
            found.append(("unconnected", [part.index]))
    return found


class Edge:
    """One module of a line, and the beams that could stand for it: (part, stretch, module along it, layer, said)."""

    def __init__(self, line, start, end):
        self.line, self.start, self.end = line, start, end
        self.covers = []


class Coverage:
    """Rules 4 and 5."""

    def __init__(self, parts, joints, sketch):
        self.parts, self.joints, self.sketch = parts, joints, sketch
        self.points, self.at = [], []
        self.edges = self.make_edges()
        self.ends = [(self.node(e.start), self.node(e.end)) for e in self.edges]
        self.at = [[] for _ in self.points]
        for e, ends in enumerate(self.ends):
            for node in ends:
                self.at[node].append(e)
        self.piece_of_line = self.find_pieces()
        self.assembly = self.find_assemblies()
        self.taken = self.match_pieces()
        self.keep_own()
        self.match_modules()

    def make_edges(self):
        edges = []
        for number, line in enumerate(self.sketch.get("lines", [])):
            start, end = tuple(line["from"]), tuple(line["to"])
            count = max(1, round(length(sub(end, start))))
            unit = mul(1.0 / count, sub(end, start))
            own = [Edge(number, add(start, mul(k, unit)), add(start, mul(k + 1, unit))) for k in range(count)]
            for part in self.parts:
                if part.is_beam:
                    for s, stretch in enumerate(part.facts["stretches"]):
                        self.cover(part, s, stretch, line, own)
            edges += own
        return edges

    def cover(self, part, number, stretch, line, edges):
        a, b = part.point(stretch["from"]), part.point(stretch["to"])
        axis = part.direction(part.facts["solid"][0]["axis"])
        start = edges[0].start
        d = sub(edges[0].end, start)
        along = sub(b, a)
        if abs(dot(d, along)) < PARALLEL * length(d) * length(along):
            return
        offset = sub(a, start)
        layer = dot(offset, axis)
        thin = part.facts["thickness"] < 1
        aside = sub(sub(offset, mul(dot(offset, d), d)), mul(layer, axis))
        if not self.is_layer(layer, thin, line, axis) or length(aside) > OFF_LINE:
            return
        first, last = sorted((dot(offset, d), dot(offset, d) + dot(along, d)))
        said = math.floor((-layer if sum(axis) < 0 else layer) + 0.5) == part.layer
        for k in range(max(0, math.ceil(first - OFF_LINE)), min(len(edges), math.floor(last + OFF_LINE))):
            edge = edges[k]
            ahead = -1.0 if d[0] + 3 * d[1] + 9 * d[2] < 0 else 1.0
            middle = ahead * dot(mul(0.5, add(edge.start, edge.end)), d)
            edge.covers.append((part.index, number, math.floor(2 * middle + 0.5), abs(layer), said))

    @staticmethod
    def is_layer(layer, thin, line, axis):
        limit = (0.25 if thin else 0.0) if line.get("exact") else MOST_LAYERS + 0.25
        off = abs(layer - math.floor(layer) - 0.5) - 0.25 if thin else layer - math.floor(layer + 0.5)
        wanted = line.get("holeAxis")
        fits = wanted is None or abs(axis["xyz".index(wanted)]) >= PARALLEL
        return abs(layer) <= limit + OFF_LINE and abs(off) <= OFF_LINE and fits

    def node(self, p):
        for i, q in enumerate(self.points):
            if abs(p[0] - q[0]) <= SAME_NODE and length(sub(p, q)) <= SAME_NODE:
                return i
        self.points.append(p)
        return len(self.points) - 1

    def find_pieces(self):
        groups = Groups(len(self.sketch.get("lines", [])))
        for edges in self.at:
            for e in edges:
                groups.join(self.edges[edges[0]].line, self.edges[e].line)
        return [groups.find(line) for line in range(len(groups.parent))]

    def find_assemblies(self):
        groups = Groups(len(self.parts))
        touched, held = set(), set()
        for j in self.joints:
            touched |= {j.male.part, j.female.part}
            if j.holds:
                held |= {j.male.part, j.female.part}
                groups.join(j.male.part, j.female.part)
        alone = {p.index for p in self.parts if p.is_beam and p.index not in touched}
        return {p.index: groups.find(p.index) for p in self.parts if p.index in held or p.index in alone}

    def match_pieces(self):
        """Pieces of the sketch with assemblies that cover all of what is covered of them, as many as possible."""
        options = {}
        for piece in set(self.piece_of_line):
            covered = [{self.assembly.get(c[0]) for c in e.covers} - {None} for e in self.edges
                       if self.piece_of_line[e.line] == piece]
            covered = [assemblies for assemblies in covered if assemblies]
            options[piece] = sorted(set.intersection(*covered)) if covered else []
        owner = {}

        def give(piece, seen):
            for assembly in options[piece]:
                if assembly not in seen:
                    seen.add(assembly)
                    if assembly not in owner or give(owner[assembly], seen):
                        owner[assembly] = piece
                        return True
            return False

        for piece in sorted(options):
            give(piece, set())
        return owner

    def keep_own(self):
        """A piece that has its assembly is covered by nothing else."""
        own = {piece: assembly for assembly, piece in self.taken.items()}
        for edge in self.edges:
            piece = self.piece_of_line[edge.line]
            edge.covers = [c for c in edge.covers if piece not in own or self.assembly.get(c[0]) == own[piece]]

    def match_modules(self):
        """Each module of a beam stands for one edge: edges with modules, as many as possible."""
        places = [tuple(sorted(ends)) for ends in self.ends]
        wanted = {}
        for place, edge in zip(places, self.edges):
            for c in edge.covers:
                wanted.setdefault(place, {}).setdefault(c[:3], (not c[4], c[3]))
        owner = {}

        def give(place, seen):
            for module in sorted(wanted[place], key=lambda m: (wanted[place][m], m)):
                if module not in seen:
                    seen.add(module)
                    if module not in owner or give(owner[module], seen):
                        owner[module] = place
                        return True
            return False

        for place in sorted(wanted, key=lambda p: (min(wanted[p].values()), p)):
            give(place, set())
        said = {c[0] for edge in self.edges for c in edge.covers if c[4]}
        for place in sorted(wanted, key=lambda p: (min(wanted[p].values()), p)):
            for module, (unsaid, _) in wanted[place].items():
                if module not in owner and not (unsaid and module[0] in said):
                    owner[module] = place
        for place, edge in zip(places, self.edges):
            edge.covers = [c for c in edge.covers if owner.get(c[:3]) == place]

    def assembly_problems(self):
        found = []
        assemblies = set(self.assembly.values())
        if not self.sketch.get("lines"):
            first = self.assembly.get(0)
            return [("separate", [a]) for a in assemblies if a != first]
        found += [("separate", [a]) for a in sorted(assemblies) if a not in self.taken]
        matched = set(self.taken.values())
        for piece in sorted(set(self.piece_of_line) - matched):
            if not found and any(e.covers for e in self.edges if self.piece_of_line[e.line] == piece):
                found.append(("separate", []))
        return found

    def coverage_problems(self):
        found = []
        i = 0
        while i < len(self.edges):
            last = i
            if not self.edges[i].covers:
                while (last + 1 < len(self.edges) and self.edges[last + 1].line == self.edges[i].line
                       and not self.edges[last + 1].covers):
                    last += 1
                if not self.bridged(i, last):
                    found.append(("uncovered", [self.edges[i].line]))
            i = last + 1
        return found

    def bridged(self, first, last):
        if last - first + 1 <= BRIDGE and self.bridged_by_mechanism(first, last):
            return True
        if self.sketch["lines"][self.edges[first].line].get("holeAxis"):
            return False
        axles = self.axles_along(self.edges[first].start, self.edges[last].end)
        return any(self.bridged_by_axle(axle, first, last) for axle in axles)

    def bridged_by_mechanism(self, first, last):
        groups = self.groups_near(first, last)
        one = {groups.find(b) for b in self.beams_from(self.ends[first][0], first, last)}
        other = {groups.find(b) for b in self.beams_from(self.ends[last][1], first, last)}
        return bool(one & other)

    def bridged_by_axle(self, axle, first, last):
        if not any(j.male.part == axle and j.good and j.holds and self.parts[j.female.part].is_beam for j in self.joints):
            return False
        groups = self.groups_near(first, last)
        nodes = {self.ends[first][0]} | {self.ends[e][1] for e in range(first, last + 1)}
        for node in nodes:
            alone = all(first <= e <= last or axle in self.axles_along(self.edges[e].start, self.edges[e].end)
                        for e in self.at[node])
            beams = self.beams_from(node, first, last)
            if not alone and not any(groups.find(b) == groups.find(axle) for b in beams):
                return False
        return True

    def axles_along(self, a, b):
        found = []
        for part in self.parts:
            if part.facts is None or part.facts["class"] != "axle":
                continue
            for feature in part.facts["features"]:
                if feature["kind"] == "axle" and all(self.on_axle(part, feature, p) for p in (a, b)):
                    found.append(part.index)
        return found

    @staticmethod
    def on_axle(part, feature, p):
        axis = part.direction(feature["axis"])
        offset = sub(p, part.point(feature["center"]))
        along = dot(offset, axis)
        return (length(sub(offset, mul(along, axis))) <= COAXIAL_DISTANCE
                and abs(along) <= feature["length"] / 2 - 0.5 + COAXIAL_DISTANCE)

    def groups_near(self, first, last):
        """What connectors near these edges join, other than through the length of a beam."""
        a, b = self.edges[first].start, self.edges[last].end
        d = sub(b, a)

        def distance(p):
            t = min(1.0, max(0.0, dot(sub(p, a), d) / dot(d, d)))
            return length(sub(sub(p, a), mul(t, d)))

        near = set()
        for j in self.joints:
            if distance(j.female.at) <= BRIDGE:
                near |= {j.male.part, j.female.part}
        near = {i for i in near if not self.parts[i].is_beam}
        groups = Groups(len(self.parts))
        for j in self.joints:
            if j.good and j.holds and (j.male.part in near or j.female.part in near):
                groups.join(j.male.part, j.female.part)
        return groups

    def beams_from(self, node, first, last):
        """Beams met first on every way away from a node, within three edges."""
        beams, seen, front = set(), set(), [node]
        for _ in range(int(BRIDGE)):
            following = []
            for at in front:
                for e in self.at[at]:
                    if first <= e <= last or e in seen:
                        continue
                    seen.add(e)
                    beams |= {c[0] for c in self.edges[e].covers}
                    if not self.edges[e].covers:
                        following.append(self.ends[e][1] if self.ends[e][0] == at else self.ends[e][0])
            front = following
        return beams


def score(model, facts):
    """What is wrong with a model, by item."""
    parts = [Placed(i, source, facts.get(source["part"])) for i, source in enumerate(model["parts"])]
    sketch = model.get("sketch") or {}
    real = [("unknownPart" if p.facts is None else "rotation", [p.index]) for p in parts
            if p.facts is None or not p.is_real()]
    if not parts:
        real.append(("empty", []))
    joints = find_joints(parts)
    coverage = Coverage(parts, joints, sketch)
    items = {
        "realParts": real,
        "interpenetration": Space(parts, joints).problems() + forbidden_places(parts, sketch),
        "connections": connection_problems(parts, joints),
        "assembly": coverage.assembly_problems(),
        "coverage": coverage.coverage_problems(),
    }
    problems = [{"item": item, "kind": kind, "parts": who} for item, found in items.items() for kind, who in found]
    beams = sum(1 for p in parts if p.is_beam and len(p.facts["features"]) > 1)
    return {"valid": not problems, "items": {item: len(found) for item, found in items.items()}, "beams": beams,
            "bricks": len(parts), "problems": problems}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--parts", required=True, help="facts about parts: what `liftarm parts` prints")
    parser.add_argument("models", nargs="+", metavar="MODEL")
    options = parser.parse_args()
    sys.setrecursionlimit(100000)
    try:
        with open(options.parts, encoding="utf-8") as file:
            facts = {part["id"]: part for part in json.load(file)["parts"]}
    except (OSError, ValueError, KeyError) as error:
        print(f"score: {options.parts}: {error}", file=sys.stderr)
        return 1
    code = 0
    for path in options.models:
        try:
            with open(path, encoding="utf-8") as file:
                found = score(json.load(file), facts)
        except (OSError, ValueError, KeyError, TypeError) as error:
            print(f"score: {path}: not a model: {error!r}", file=sys.stderr)
            return 1
        code = code if found["valid"] else 2
        print(json.dumps({"file": path, **found}))
    return code


if __name__ == "__main__":
    sys.exit(main())
