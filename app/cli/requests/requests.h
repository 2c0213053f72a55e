// SPDX-License-Identifier: GPL-3.0-or-later
// The requests of the commands, as texts that a user typed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/settings/scale_marks.h"

namespace mes::cli {

/// Options of reading: threshold of a traced picture (empty: found automatically), degrees of a map, sampling of
/// curves.
struct ReadingOptions {
  std::string threshold;
  std::string specks;
  std::string figure;           ///< "dark" or "light"
  bool keeps_degrees = false;   ///< longitude and latitude are not projected
  bool keeps_vertices = false;  ///< curves are sampled at their vertices alone
  bool wants_curves = false;    ///< the command takes samples of the curves itself
  std::string system{};         ///< coordinate system of the positions; empty: that of the file
};

/// The common part of all commands that read samples and compute.
struct Source {
  std::string file;
  std::string from;  ///< id of the input format; empty: detect it
  ReadingOptions reading{};
  std::string precision;              ///< empty: that of a session, or else fast
  std::vector<std::string> settings;  ///< NAME=VALUE; missing ones are those of a session, or else the defaults
};

struct ComputeRequest {
  Source source;
  std::string layers;
  bool with_timing = true;
  bool with_digests = false;
  std::string output;
  bool force = false;  ///< overwrites the output even if it was read and has changed since
};

struct SweepRequest {
  Source source;
  std::string parameter;  ///< NAME=FROM..TO
  std::string steps;
  std::string layers;
  std::string output;
  bool force = false;
};

struct BranchesRequest {
  Source source;
  std::string layer = "medial-axis";
  std::string output;
  bool force = false;
};

struct CenterlineRequest {
  std::string file;
  std::string from;
  ReadingOptions reading{};
  std::string prune = "0.5";
  std::string smooth = "25%";
  bool is_extended = false;
  bool is_exact = false;  ///< lines of the outlines themselves, without samples
  std::string branches = "1";
  std::vector<std::string> between;  ///< two points X,Y, or none
  std::string every;                 ///< spacing of stations; empty: the lines themselves
  bool are_features_apart = false;
  std::string format;  ///< empty: by the name of the output, or geojson
  std::string output;
  bool force = false;
};

struct PersistenceRequest {
  Source source;
  std::string of = "samples";
  std::string output;
  bool force = false;
};

/// The request of `repair` and `decimate`.
struct ResampleRequest {
  std::string file;
  std::string from;
  ReadingOptions reading{};
  std::string epsilon = "0.25";
  std::string output;
  bool force = false;
};

struct ExportRequest {
  Source source;
  std::string layer;
  std::string structure;  ///< instead of a layer
  std::string cells;      ///< "box", "hull" or "outline", instead of a layer; empty: none
  std::string table;      ///< table of the structure
  std::string format;
  std::string output;
  bool force = false;
};

struct RenderRequest {
  Source source;
  std::string layers;
  std::string bundle;  ///< name or file, instead of layers
  std::string size = "1600x1200";
  std::string figure_size;  ///< for vector formats, on paper; empty: `size`
  std::string bounds = "view";
  std::string rasterized;   ///< ids of layers that are pictures in a vector format; empty: none
  std::string dpi = "300";  ///< for these layers
  std::string view;         ///< empty: fit, or the view of a session
  std::string scale = "1";
  std::string background = "ffffff";
  std::vector<std::string> styles;  ///< LAYER:KEY=VALUE[,KEY=VALUE...]
  std::string compared;             ///< WHAT=VALUE,VALUE...: panes side by side; empty: one picture
  bool has_free_cameras = false;    ///< each pane shows all its contents
  bool with_differences = false;    ///< marks elements that only some panes have
  std::string evolution;            ///< evolution whose steps are compared
  std::string image;                ///< FILE or FILE:X,Y,WIDTH, below everything; empty: none
  bool with_legend = true;          ///< if a colour map is used
  bool with_key = false;
  std::optional<PaperPlace> legend_at;  ///< nothing: where it hides least
  ScaleMarks marks{};
  bool with_annotations = true;
  std::string title;        ///< above the drawing; empty: no title
  bool with_source = true;  ///< the picture carries samples, view and layers
  std::string format;       ///< extension without its dot; empty: that of the output's name
  std::string output;
  bool force = false;
};

/// Frames and a video of a session that is played.
struct FilmRequest {
  std::string frames;  ///< folder; empty: only the video
  std::string video;   ///< .mp4 or .webm; empty: only the frames
  std::string size = "1280x720";
  std::string fps = "12";
  bool with_legend = true;  ///< if a colour map is used
  bool with_key = false;
  ScaleMarks marks{};
  bool with_annotations = true;
  bool with_source = true;  ///< the manifest of the frames holds the session
  std::string title;        ///< above the drawing; empty: no title
  std::string shard;        ///< "3/16": every 16th frame beginning with the 3rd; empty: all
};

struct PlayRequest {
  std::string session;
  FilmRequest film;
};

struct DemoRequest {
  FilmRequest film;
};

struct LessonRequest {
  std::string file;   ///< or the name of a lesson that comes with the program
  std::string steps;  ///< "2-4", "1,3-5"; empty: all
  // The named outputs are written; if there are none, the steps are listed.
  std::string pdf;
  std::string html;
  std::string web;     ///< folder
  std::string frames;  ///< folder
  std::string video;   ///< .mp4 or .webm
  std::string vtt;
  std::string size = "1280x720";  ///< size of frames
  std::string figure_size = "slide";
  std::string scale = "1.25";
  std::string background = "ffffff";
  bool with_legend = true;  ///< if a colour map is used
  bool with_key = false;
  ScaleMarks marks{};
  bool with_annotations = true;
  bool with_source = true;  ///< the PDF carries the session
  bool force = false;
};

struct EvolveRequest {
  std::string file;
  std::string from;
  ReadingOptions reading{};
  // Empty values are those of a session.
  std::string evolution;
  std::string steps;
  std::string seed;                   ///< empty: 1
  std::vector<std::string> settings;  ///< NAME=VALUE
  std::string output;
  bool force = false;
};

struct ShapeCommand {
  std::string name;                   ///< id of a shape
  std::vector<std::string> settings;  ///< KEY=VALUE, or KEY=FORMULA
  std::string samples;
  std::string spacing;
  std::string jitter = "0";
  std::string seed = "1";
  std::string output;
  bool force = false;
};

struct SampleRequest {
  std::string file;
  std::string from;
  ReadingOptions reading{};
  std::string rule;  ///< id of a sampling rule; empty: chosen by the other options
  std::string samples;
  std::string spacing;
  std::string epsilon;
  std::string turn;          ///< degrees
  std::string corner_angle;  ///< degrees
  std::string corner_radius;
  std::string jitter;
  std::string seed = "1";
  std::string output;
  bool force = false;
};

struct TextCommand {
  std::string text;
  std::string font;  ///< name or file; empty: the font of the program
  std::string size = "100";
  std::string line_spacing = "1";
  bool no_kerning = false;
  std::string samples;
  std::string spacing;
  std::string jitter = "0";
  std::string seed = "1";
  std::string output;
  bool force = false;
};

struct ListRequest {
  std::string what;
  bool as_json = false;
};

struct NewRequest {
  std::string what;
  std::string name;
  std::string output;  ///< empty: NAME.cpp
  bool force = false;
};

struct CheckRequest {
  std::vector<std::string> files;
};

struct ManualRequest {
  bool as_man_page = false;
  std::string output;
};

struct CompletionsRequest {
  std::string shell;
  std::string output;
};

}  // namespace mes::cli
