package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.installation.FeaturePoses;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.scene.WaypointMarkers;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.ShownMeasure;
import org.pendant.kit.form.Measure;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Timing;
import org.pendant.project.program.TreeNames;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;

/** Program places: the places of a program as they are shown in 3D. */
final class ProgramPlaces {
  /** More frames than this are slow to draw without a graphics card, and cannot be told apart. */
  private static final int MOST = 200;

  private final ProgramTree tree;
  private final PoseForm form;
  private final Map<String, Integer> numbers = new LinkedHashMap<>();
  private final Map<String, Pose> poses = new LinkedHashMap<>();

  private ProgramPlaces(ProgramTree tree, Installation installation, PoseForm form) {
    this.tree = tree;
    this.form = form;
    tree.waypoints()
        .forEach(
            (name, place) -> {
              Optional<Pose> pose = inBase(place, installation);
              if (pose.isPresent() && numbers.size() < MOST) {
                numbers.put(name, numbers.size());
                poses.put(name, pose.get());
              }
            });
  }

  /**
   * Places and the order in which they are gone to.
   *
   * @param selected keys of nodes; the places that they name are marked
   * @param form in whose units speeds are said
   */
  static WaypointMarkers of(
      ProgramTree tree, Installation installation, Set<Long> selected, PoseForm form) {
    return new ProgramPlaces(tree, installation, form).marks(selected);
  }

  private WaypointMarkers marks(Set<Long> selected) {
    List<String> chosen =
        tree.nodes().stream()
            .filter(each -> selected.contains(each.key()))
            .flatMap(each -> TreeNames.waypoints(each.step()).stream())
            .toList();
    List<WaypointMarkers.Mark> marks = new ArrayList<>();
    Map<String, Long> namedBy = new HashMap<>();
    tree.forEach(
        node ->
            TreeNames.waypoints(node.step())
                .forEach(name -> namedBy.putIfAbsent(name, node.key())));
    poses.forEach(
        (name, pose) ->
            marks.add(
                new WaypointMarkers.Mark(
                    name, pose, chosen.contains(name), namedBy.getOrDefault(name, 0L))));
    List<List<WaypointMarkers.Stop>> ways = new ArrayList<>();
    for (ProgramNode section : tree.sections()) {
      List<WaypointMarkers.Stop> way = new ArrayList<>();
      follow(section, Optional.empty(), selected, way);
      if (way.size() > 1) {
        ways.add(way);
      }
    }
    return new WaypointMarkers(marks, ways);
  }

  private void follow(
      ProgramNode node,
      Optional<MotionStep.Move> above,
      Set<Long> selected,
      List<WaypointMarkers.Stop> way) {
    if (node.suppressed()) {
      return;
    }
    if (node.step() instanceof MotionStep.Waypoint waypoint
        && waypoint.target() instanceof WaypointTarget.Fixed fixed
        && numbers.containsKey(fixed.name())) {
      way.add(
          new WaypointMarkers.Stop(
              numbers.get(fixed.name()),
              node.key(),
              above.map(move -> how(move, waypoint.timing())).orElse(""),
              selected.contains(node.key())));
    }
    Optional<MotionStep.Move> move =
        node.step() instanceof MotionStep.Move own ? Optional.of(own) : above;
    node.children().forEach(each -> follow(each, move, selected, way));
  }

  /** Such as {@code MoveL at 250 mm/s}. */
  private String how(MotionStep.Move move, Timing timing) {
    Measure speed =
        ShownMeasure.of(
            move.kind() == MoveKind.JOINT ? Measure.DEGREE_PER_S : Measure.MILLIMETRE_PER_S, form);
    String name = NodeLabels.shown(move);
    return switch (timing) {
      case Timing.AsMove _ -> text("moveAtSpeed", name, speed.words(move.speed()));
      case Timing.Own own -> text("moveAtSpeed", name, speed.words(own.speed()));
      case Timing.Duration duration ->
          text("moveInTime", name, Measure.SECOND.words(duration.timeS()));
    };
  }

  private static Optional<Pose> inBase(WaypointPosition place, Installation installation) {
    if (place.feature().equals(WaypointPosition.BASE)) {
      return Optional.of(place.tcp());
    }
    return installation
        .feature(place.feature())
        .flatMap(FeaturePoses::pose)
        .map(frame -> Poses.trans(frame, place.tcp()));
  }
}
