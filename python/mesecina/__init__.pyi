# SPDX-License-Identifier: GPL-3.0-or-later
# Written by scripts/make_stubs.py.
from typing import Any, Callable, ContextManager, Iterator, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray

__version__: str

def evolution(*, id: Any = ...) -> Callable[[Callable[..., Any]], Experiment]: ...
def evolutions() -> list[dict[str, Any]]: ...
def formats() -> list[dict[str, Any]]: ...
def layer(*, rows: Any, kind: Any, id: Any = ..., name: Any = ..., inputs: Any = ..., scalar: Any = ..., color: Any = ..., opacity: Any = ..., line_width: Any = ..., point_size: Any = ..., color_map: Any = ...) -> Callable[[Callable[..., Any]], Experiment]: ...
def layers() -> list[dict[str, Any]]: ...
def map(function: Any, items: Any, executor: Any = ...) -> Iterator[Result]: ...
def open(path: Any, format: Any = ..., *, vertices: Any = ..., degrees: Any = ..., crs: Any = ..., experiments: Any = ...) -> Session: ...
def parameters() -> list[dict[str, Any]]: ...
def shape(name: Any, *, samples: Any = ..., spacing: Any = ..., jitter: Any = ..., seed: Any = ..., **parameters: Any) -> Session: ...
def shapes() -> list[dict[str, Any]]: ...
def structure(*, id: Any = ..., inputs: Any = ..., rows: Any = ...) -> Callable[[Callable[..., Any]], Experiment]: ...
def structures() -> list[dict[str, Any]]: ...
def text(letters: Any, **options: Any) -> Session: ...
def version(*arguments: Any) -> str: ...
def window(session: Any, experiments: Any = ...) -> Window: ...

class Result(NamedTuple):
    item: Any
    value: Any
    error: Optional[Exception]

class Axis:
    points: NDArray[np.float64]
    radius: NDArray[np.float64]
    edges: NDArray[np.int64]
    length: NDArray[np.float64]
    samples: NDArray[np.uint32]
    rows: NDArray[np.uint32]
    def __init__(self, bench: Any) -> None: ...
    @property
    def lambda_(self) -> NDArray[np.float64]: ...
    @property
    def angle(self) -> NDArray[np.float64]: ...
    @property
    def degree(self) -> NDArray[np.int64]: ...
    def to_networkx(self) -> Any: ...

class Certificate:
    def __init__(self, bench: Any) -> None: ...
    @property
    def light(self) -> str: ...
    @property
    def is_proved(self) -> bool: ...
    @property
    def findings(self) -> list[dict[str, Any]]: ...
    @property
    def reasons(self) -> list[str]: ...

class ComputationFailed(RuntimeError):
    structure: str
    witnesses: list[int]
    def __init__(self, text: Any, structure: Any = ..., witnesses: Any = ...) -> None: ...

class Experiment:
    what: str
    id: str
    description: str
    parameters: list[dict[str, Any]]
    def __init__(self, function: Any, what: Any, given_id: Any, inputs: Any, spec: Any) -> None: ...
    def __call__(self, *arguments: Any, **named: Any) -> Any: ...

class InputError(ValueError):
    file: str
    line: int
    column: int
    def __init__(self, text: Any, file: Any = ..., line: Any = ..., column: Any = ...) -> None: ...

class Picture:
    data: bytes
    suffix: str
    def __init__(self, data: Any, suffix: Any) -> None: ...
    def save(self, path: Any) -> None: ...

class ProgramError(RuntimeError):
    status: int
    def __init__(self, text: Any, status: Any = ...) -> None: ...

class Session:
    remarks: list[str]
    experiments: tuple[Experiment, ...]
    def __init__(self, points: Any = ..., *, balls: Any = ..., contours: Any = ..., history: Any = ..., experiments: Any = ...) -> None: ...
    @classmethod
    def from_polygons(cls, *geometries: Any, vertices: Any = ...) -> Session: ...
    @classmethod
    def from_image(cls, image: Any) -> Session: ...
    def save(self, path: Any, format: Any = ...) -> None: ...
    def copy(self) -> Session: ...
    @property
    def points(self) -> NDArray[np.float64]: ...
    @property
    def ids(self) -> NDArray[np.uint32]: ...
    @property
    def balls(self) -> NDArray[np.float64]: ...
    @property
    def ball_ids(self) -> NDArray[np.uint32]: ...
    @property
    def contours(self) -> list[tuple[NDArray[np.uint32], bool]]: ...
    def insert(self, points: Any) -> Any: ...
    def move(self, ids: Any, points: Any) -> None: ...
    def remove(self, ids: Any) -> None: ...
    def insert_balls(self, balls: Any) -> NDArray[np.uint32]: ...
    def change_balls(self, ids: Any, balls: Any) -> None: ...
    def remove_balls(self, ids: Any) -> None: ...
    def edit(self, name: Any = ...) -> ContextManager[Session]: ...
    def undo(self) -> bool: ...
    def redo(self) -> bool: ...
    def on_change(self, callback: Any) -> Any: ...
    def set(self, name: Any, value: Any) -> None: ...
    def value(self, name: Any) -> Any: ...
    def run(self) -> None: ...
    def structure(self, structure: Any) -> Structure: ...
    @property
    def axis(self) -> Axis: ...
    @property
    def changed(self) -> Any: ...
    @property
    def certificate(self) -> Certificate: ...
    def statistics(self, structure: Any) -> dict[str, Any]: ...
    def digest(self, layer: Any) -> str: ...
    def instances(self, layer: Any, kind: Any) -> NDArray[np.float64]: ...
    def plot(self, ax: Any = ..., layers: Any = ...) -> Any: ...
    def render(self, layers: Any = ..., width: Any = ..., height: Any = ..., format: Any = ..., **options: Any) -> Picture: ...
    def compute(self, layers: Any = ..., **options: Any) -> dict[str, Any]: ...
    def branches(self, layer: Any = ...) -> NDArray[Any]: ...
    def centerline(self, **options: Any) -> NDArray[Any]: ...
    def persistence(self, of: Any = ...) -> NDArray[Any]: ...
    def sweep(self, parameter: Any, low: Any, high: Any, steps: Any, layers: Any = ...) -> NDArray[Any]: ...
    def repair(self, **options: Any) -> Session: ...
    def decimate(self, **options: Any) -> Session: ...
    def sample(self, **options: Any) -> Session: ...
    def evolve(self, evolution: Any, steps: Any = ..., **options: Any) -> Session: ...
    def export(self, layer: Any, format: Any, **options: Any) -> bytes: ...
    def __len__(self) -> int: ...
    samples: _Samples
    settings: _Settings
    curve_source: _Settings
    center_line_ends: _Settings
    scaled_balls: _ScaledBalls
    shared_borders: _SharedBorders
    delaunay: _Delaunay
    last_change: _LastChange
    one_step_crust: _OneStepCrust
    labels: _Labels
    curve: _Curve
    voronoi_vertices: _VoronoiVertices
    inner_balls: _InnerBalls
    medial_axis: _MedialAxis
    axis_nodes: _AxisNodes
    lambda_axis: _LambdaAxis
    angle_axis: _AngleAxis
    center_lines: _CenterLines
    cover_dates: _CoverDates
    cover_axis: _CoverAxis
    curve_sampling: _CurveSampling
    feature_size: _FeatureSize
    alpha_filtration: _AlphaFiltration
    alpha_complex: _AlphaComplex
    axis_certificate: _AxisCertificate
    a_union: _AUnion
    axis_difference: _AxisDifference
    a_precision_difference: _APrecisionDifference
    a_power_diagram: _APowerDiagram
    a_v_diagram: _AVDiagram
    voronoi_ball_diagram: _APowerDiagram
    b_union: _AUnion
    b_precision_difference: _APrecisionDifference
    b_power_diagram: _APowerDiagram
    a_ball_sampling: _ABallSampling
    b_ball_sampling: _ABallSampling
    b_v_diagram: _AVDiagram
    a_ball_filtration: _ABallFiltration
    a_grown_complex: _AGrownComplex
    b_ball_filtration: _ABallFiltration
    b_grown_complex: _AGrownComplex
    axis_sampling: _AxisSampling
    scale_union: _AUnion
    scale_ball_sampling: _ABallSampling
    a_scale_union: _AUnion
    a_scale_sampling: _ABallSampling
    a_skeleton_union: _AUnion
    b_scale_union: _AUnion
    b_scale_sampling: _ABallSampling
    b_skeleton_union: _AUnion
    lambda_union: _AUnion
    angle_union: _AUnion
    cover_union: _AUnion
    poles: _Poles
    pole_labels: _PoleLabels
    polar_diagram: _APowerDiagram
    power_crust: _PowerCrust
    p_union: _AUnion
    p_power_diagram: _APowerDiagram
    p_v_diagram: _AVDiagram
    p_ball_sampling: _ABallSampling
    p_ball_filtration: _ABallFiltration
    p_grown_complex: _AGrownComplex
    p_scale_union: _AUnion
    p_scale_sampling: _ABallSampling
    p_skeleton_union: _AUnion
    outline_axis: _OutlineAxis
    axis_deviation: _AxisDeviation

class Structure:
    def __init__(self, bench: Any, description: Any) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def tables(self) -> list[str]: ...
    @property
    def statistics(self) -> dict[str, Any]: ...
    def __getitem__(self, name: Any) -> Any: ...

class Table:
    def __init__(self, bench: Any, structure: Any, description: Any) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def columns(self) -> list[str]: ...
    @property
    def rows(self) -> NDArray[np.uint32]: ...
    @property
    def changed(self) -> Optional[NDArray[np.uint32]]: ...
    def compact(self) -> NDArray[Any]: ...
    def to_pandas(self) -> Any: ...
    def __getitem__(self, name: Any) -> Any: ...
    def __len__(self) -> int: ...

class Window:
    def __init__(self, session: Any, experiments: Any = ...) -> None: ...
    @property
    def is_open(self) -> bool: ...
    def poll(self) -> bool: ...
    def wait(self, timeout: Any = ...) -> bool: ...
    def close(self) -> None: ...

class _SamplesSamples(Table):
    position: NDArray[np.float64]
    id: NDArray[np.uint32]

class _Samples(Structure):
    samples: _SamplesSamples

class _Settings(Structure):
    ...

class _BallsBalls(Table):
    center: NDArray[np.float64]
    radius: NDArray[np.float64]
    id: NDArray[np.uint32]

class _Balls(Structure):
    balls: _BallsBalls

class _ScaledBallsBalls(Table):
    scaled_radius: NDArray[np.float64]

class _ScaledBalls(Structure):
    balls: _ScaledBallsBalls

class _ContoursLinks(Table):
    samples: NDArray[np.uint32]
    contour: NDArray[np.uint32]
    is_closed: NDArray[np.bool_]

class _Contours(Structure):
    links: _ContoursLinks

class _SharedBordersBorders(Table):
    samples: NDArray[np.uint32]

class _SharedBorders(Structure):
    borders: _SharedBordersBorders
    seams: _SharedBordersBorders

class _DelaunaySites(Table):
    position: NDArray[np.float64]
    sample: NDArray[np.uint32]
    face: NDArray[np.uint32]

class _DelaunayFaces(Table):
    sites: NDArray[np.uint32]
    faces: NDArray[np.uint32]
    edges: NDArray[np.uint32]
    is_finite: NDArray[np.bool_]
    circumcenter: NDArray[np.float64]
    circumradius: NDArray[np.float64]

class _DelaunayEdges(Table):
    sites: NDArray[np.uint32]
    faces: NDArray[np.uint32]

class _DelaunaySamples(Table):
    site: NDArray[np.uint32]
    next_duplicate: NDArray[np.uint32]

class _Delaunay(Structure):
    sites: _DelaunaySites
    faces: _DelaunayFaces
    edges: _DelaunayEdges
    samples: _DelaunaySamples

class _LastChangeFaces(Table):
    is_touched: NDArray[np.bool_]

class _LastChange(Structure):
    faces: _LastChangeFaces
    edges: _LastChangeFaces

class _OneStepCrustEdges(Table):
    is_crust: NDArray[np.bool_]
    is_shared: NDArray[np.bool_]
    is_cocircular: NDArray[np.bool_]
    confidence: NDArray[np.float64]

class _OneStepCrustSites(Table):
    degree: NDArray[np.uint8]
    wall_degree: NDArray[np.uint32]

class _OneStepCrustFaces(Table):
    wall_bits: NDArray[np.uint8]

class _OneStepCrust(Structure):
    edges: _OneStepCrustEdges
    sites: _OneStepCrustSites
    faces: _OneStepCrustFaces

class _LabelsFaces(Table):
    is_inside: NDArray[np.bool_]

class _LabelsEdges(Table):
    is_conflict: NDArray[np.bool_]

class _Labels(Structure):
    faces: _LabelsFaces
    edges: _LabelsEdges

class _CurveSites(Table):
    normal: NDArray[np.float64]
    spacing: NDArray[np.float64]

class _CurveEdges(Table):
    chain: NDArray[np.uint32]

class _CurveChains(Table):
    is_closed: NDArray[np.bool_]
    has_inside: NDArray[np.bool_]
    edge_count: NDArray[np.uint32]
    first_site: NDArray[np.uint32]
    last_site: NDArray[np.uint32]
    first_edge: NDArray[np.uint32]

class _Curve(Structure):
    sites: _CurveSites
    edges: _CurveEdges
    chains: _CurveChains

class _VoronoiVerticesFaces(Table):
    vertex: NDArray[np.uint32]

class _VoronoiVertices(Structure):
    faces: _VoronoiVerticesFaces

class _InnerBallsFaces(Table):
    ball: NDArray[np.uint32]
    center: NDArray[np.float64]
    radius: NDArray[np.float64]

class _InnerBalls(Structure):
    faces: _InnerBallsFaces

class _MedialAxisEdges(Table):
    nodes: NDArray[np.uint32]
    is_zero_length: NDArray[np.bool_]
    length: NDArray[np.float64]

class _MedialAxis(Structure):
    edges: _MedialAxisEdges

class _AxisNodesFaces(Table):
    degree: NDArray[np.uint32]

class _AxisNodes(Structure):
    faces: _AxisNodesFaces

class _LambdaAxisEdges(Table):
    lambda_: NDArray[np.float64]
    is_kept: NDArray[np.bool_]
    is_cut: NDArray[np.bool_]

class _LambdaAxisFaces(Table):
    lambda_: NDArray[np.float64]
    is_kept: NDArray[np.bool_]

class _LambdaAxisRemovedPieces(Table):
    edge: NDArray[np.uint32]
    from_: NDArray[np.float64]
    to: NDArray[np.float64]

class _LambdaAxis(Structure):
    edges: _LambdaAxisEdges
    faces: _LambdaAxisFaces
    removed_pieces: _LambdaAxisRemovedPieces

class _AngleAxisEdges(Table):
    object_angle: NDArray[np.float64]
    is_kept: NDArray[np.bool_]
    is_cut: NDArray[np.bool_]

class _AngleAxisFaces(Table):
    object_angle: NDArray[np.float64]
    is_kept: NDArray[np.bool_]

class _AngleAxis(Structure):
    edges: _AngleAxisEdges
    faces: _AngleAxisFaces
    removed_pieces: _LambdaAxisRemovedPieces

class _CenterLinesLines(Table):
    length: NDArray[np.float64]
    widths: NDArray[np.float64]
    is_closed: NDArray[np.bool_]

class _CenterLinesPieces(Table):
    from_: NDArray[np.float64]
    to: NDArray[np.float64]
    line: NDArray[np.uint32]

class _CenterLinesTransects(Table):
    left: NDArray[np.float64]
    axis: NDArray[np.float64]
    right: NDArray[np.float64]
    place: NDArray[np.float64]
    station: NDArray[np.float64]
    width: NDArray[np.float64]
    direction: NDArray[np.float64]
    line: NDArray[np.uint32]

class _CenterLines(Structure):
    lines: _CenterLinesLines
    pieces: _CenterLinesPieces
    transects: _CenterLinesTransects

class _CoverDatesFaces(Table):
    cover_date: NDArray[np.float64]

class _CoverDates(Structure):
    faces: _CoverDatesFaces

class _CoverAxisEdges(Table):
    cover: NDArray[np.float64]
    is_kept: NDArray[np.bool_]
    is_cut: NDArray[np.bool_]

class _CoverAxisFaces(Table):
    cover: NDArray[np.float64]
    is_kept: NDArray[np.bool_]

class _CoverAxis(Structure):
    edges: _CoverAxisEdges
    faces: _CoverAxisFaces
    removed_pieces: _LambdaAxisRemovedPieces

class _CurveSamplingSamples(Table):
    is_off_curves: NDArray[np.bool_]

class _CurveSampling(Structure):
    samples: _CurveSamplingSamples

class _FeatureSizeSites(Table):
    feature_size: NDArray[np.float64]
    nearest: NDArray[np.uint32]
    is_exempt: NDArray[np.bool_]

class _FeatureSizeEdges(Table):
    epsilon: NDArray[np.float64]

class _FeatureSize(Structure):
    sites: _FeatureSizeSites
    edges: _FeatureSizeEdges

class _AlphaFiltrationEdges(Table):
    rank: NDArray[np.uint32]
    alpha: NDArray[np.float64]

class _AlphaFiltrationClasses(Table):
    is_hole: NDArray[np.bool_]
    birth: NDArray[np.float64]
    death: NDArray[np.float64]
    site: NDArray[np.uint32]
    edge: NDArray[np.uint32]
    face: NDArray[np.uint32]

class _AlphaFiltration(Structure):
    edges: _AlphaFiltrationEdges
    faces: _AlphaFiltrationEdges
    classes: _AlphaFiltrationClasses

class _AlphaComplexSites(Table):
    is_alone: NDArray[np.bool_]

class _AlphaComplexEdges(Table):
    is_held: NDArray[np.bool_]

class _AlphaComplexEnds(Table):
    edge: NDArray[np.uint32]
    site: NDArray[np.uint32]
    from_: NDArray[np.float64]
    to: NDArray[np.float64]

class _AlphaComplexClasses(Table):
    is_present: NDArray[np.bool_]

class _AlphaComplex(Structure):
    sites: _AlphaComplexSites
    edges: _AlphaComplexEdges
    faces: _AlphaComplexEdges
    ends: _AlphaComplexEnds
    classes: _AlphaComplexClasses

class _AxisCertificateEdges(Table):
    is_bad: NDArray[np.bool_]

class _AxisCertificate(Structure):
    edges: _AxisCertificateEdges
    sites: _AxisCertificateEdges

class _AUnionBalls(Table):
    state: NDArray[np.uint8]
    center: NDArray[np.float64]
    radius: NDArray[np.float64]

class _AUnionDualEdges(Table):
    balls: NDArray[np.uint32]
    kind: NDArray[np.uint8]
    shares_sample: NDArray[np.bool_]

class _AUnionDualFaces(Table):
    balls: NDArray[np.uint32]
    sign: NDArray[np.int8]
    is_exactly_zero: NDArray[np.bool_]

class _AUnionVPoints(Table):
    position: NDArray[np.float64]
    site: NDArray[np.uint32]
    multiplicity: NDArray[np.uint32]

class _AUnionVOrigins(Table):
    v_point: NDArray[np.uint32]
    dual_edge: NDArray[np.uint32]

class _AUnionAxisPieces(Table):
    from_: NDArray[np.float64]
    to: NDArray[np.float64]
    radius_from: NDArray[np.float64]
    radius_to: NDArray[np.float64]
    balls: NDArray[np.uint32]
    v_faces: NDArray[np.uint32]
    v_points: NDArray[np.uint32]
    is_singular: NDArray[np.bool_]
    is_zero_length: NDArray[np.bool_]

class _AUnionVFaces(Table):
    v_points: NDArray[np.uint32]
    ball: NDArray[np.uint32]
    center: NDArray[np.float64]
    radius: NDArray[np.float64]
    is_inside: NDArray[np.bool_]

class _AUnionVEdges(Table):
    v_points: NDArray[np.uint32]
    v_faces: NDArray[np.uint32]
    kind: NDArray[np.uint8]

class _AUnionArcs(Table):
    ball: NDArray[np.uint32]
    is_whole: NDArray[np.bool_]
    from_: NDArray[np.float64]
    to: NDArray[np.float64]

class _AUnion(Structure):
    balls: _AUnionBalls
    dual_edges: _AUnionDualEdges
    dual_faces: _AUnionDualFaces
    v_points: _AUnionVPoints
    v_origins: _AUnionVOrigins
    axis_pieces: _AUnionAxisPieces
    v_faces: _AUnionVFaces
    v_edges: _AUnionVEdges
    arcs: _AUnionArcs

class _AxisDifferencePieces(Table):
    from_: NDArray[np.float64]
    to: NDArray[np.float64]
    only_one_step: NDArray[np.bool_]

class _AxisDifference(Structure):
    pieces: _AxisDifferencePieces

class _APrecisionDifferenceEdges(Table):
    balls: NDArray[np.uint32]
    chosen: NDArray[np.int8]
    exact: NDArray[np.int8]

class _APrecisionDifferenceFaces(Table):
    balls: NDArray[np.uint32]
    is_exact: NDArray[np.bool_]

class _APrecisionDifference(Structure):
    edges: _APrecisionDifferenceEdges
    faces: _APrecisionDifferenceFaces

class _APowerDiagramBalls(Table):
    center: NDArray[np.float64]
    radius: NDArray[np.float64]

class _APowerDiagramEdges(Table):
    balls: NDArray[np.uint32]
    kind: NDArray[np.uint8]
    from_: NDArray[np.float64]
    to: NDArray[np.float64]
    vertices: NDArray[np.uint32]
    length: NDArray[np.float64]

class _APowerDiagram(Structure):
    balls: _APowerDiagramBalls
    edges: _APowerDiagramEdges

class _AVDiagram(Structure):
    v_points: _AUnionVPoints
    v_faces: _AUnionVFaces
    v_edges: _AUnionVEdges

class _ABallSampling(Structure):
    medial: _APowerDiagramBalls
    convex: _APowerDiagramBalls

class _ABallFiltrationCorners(Table):
    ball: NDArray[np.uint32]
    center: NDArray[np.float64]
    radius: NDArray[np.float64]
    rank: NDArray[np.uint32]
    growth: NDArray[np.float64]

class _ABallFiltrationEdges(Table):
    corners: NDArray[np.uint32]
    triangles: NDArray[np.uint32]
    rank: NDArray[np.uint32]
    growth: NDArray[np.float64]

class _ABallFiltrationTriangles(Table):
    corners: NDArray[np.uint32]
    triangles: NDArray[np.uint32]
    edges: NDArray[np.uint32]
    center: NDArray[np.float64]
    rank: NDArray[np.uint32]
    growth: NDArray[np.float64]

class _ABallFiltrationClasses(Table):
    is_hole: NDArray[np.bool_]
    birth: NDArray[np.float64]
    death: NDArray[np.float64]
    corner: NDArray[np.uint32]
    edge: NDArray[np.uint32]
    triangle: NDArray[np.uint32]

class _ABallFiltration(Structure):
    corners: _ABallFiltrationCorners
    edges: _ABallFiltrationEdges
    triangles: _ABallFiltrationTriangles
    classes: _ABallFiltrationClasses

class _AGrownComplexCorners(Table):
    is_held: NDArray[np.bool_]
    is_alone: NDArray[np.bool_]
    radius: NDArray[np.float64]

class _AGrownComplexEnds(Table):
    edge: NDArray[np.uint32]
    corner: NDArray[np.uint32]
    from_: NDArray[np.float64]
    to: NDArray[np.float64]

class _AGrownComplex(Structure):
    corners: _AGrownComplexCorners
    edges: _AlphaComplexEdges
    triangles: _AlphaComplexEdges
    ends: _AGrownComplexEnds
    classes: _AlphaComplexClasses

class _AxisSampling(Structure):
    between: _APowerDiagramBalls

class _PolesSites(Table):
    plus: NDArray[np.uint32]
    minus: NDArray[np.uint32]

class _PolesFaces(Table):
    pole_count: NDArray[np.uint32]
    is_pole: NDArray[np.bool_]

class _Poles(Structure):
    sites: _PolesSites
    faces: _PolesFaces

class _PoleLabelsFaces(Table):
    is_inside_pole: NDArray[np.bool_]

class _PoleLabels(Structure):
    faces: _PoleLabelsFaces

class _PowerCrustEdges(Table):
    is_crust: NDArray[np.bool_]

class _PowerCrust(Structure):
    edges: _PowerCrustEdges

class _OutlineAxisFeatures(Table):
    from_: NDArray[np.float64]
    to: NDArray[np.float64]
    is_vertex: NDArray[np.bool_]
    center: NDArray[np.float64]

class _OutlineAxisEdges(Table):
    nodes: NDArray[np.uint32]
    features: NDArray[np.uint32]
    region: NDArray[np.uint32]
    is_parabola: NDArray[np.bool_]
    control: NDArray[np.float64]

class _OutlineAxisPieces(Table):
    from_: NDArray[np.float64]
    to: NDArray[np.float64]
    radius_from: NDArray[np.float64]
    radius_to: NDArray[np.float64]
    edge: NDArray[np.uint32]

class _OutlineAxis(Structure):
    features: _OutlineAxisFeatures
    nodes: _APowerDiagramBalls
    edges: _OutlineAxisEdges
    pieces: _OutlineAxisPieces

class _AxisDeviationPieces(Table):
    from_: NDArray[np.float64]
    to: NDArray[np.float64]
    distance: NDArray[np.float64]
    is_of_outline: NDArray[np.bool_]

class _AxisDeviation(Structure):
    pieces: _AxisDeviationPieces
