package org.pendant.desktop.help;

import java.util.List;
import java.util.Locale;
import org.pendant.models.mesh.MeshFile;

/**
 * A program that comes with Pendant.
 *
 * @param file its name
 * @param topic what it shows something of
 * @param companions names of the files that belong beside it
 */
public record Example(String file, Topic topic, List<String> companions) {
  /** What examples are sorted by. */
  public enum Topic {
    /** Moving the arm. */
    MOTION(HelpViewTexts.text("motion")),
    /** Grippers, belts and parts around the arm. */
    CELL(HelpViewTexts.text("cell")),
    /** The language by itself. */
    LANGUAGE(HelpViewTexts.text("language")),
    /** Programs made of nodes. */
    NODES(HelpViewTexts.text("nodes"));

    private final String title;

    Topic(String title) {
      this.title = title;
    }

    /** For people. */
    public String title() {
      return title;
    }
  }

  /** The companions are copied. */
  public Example {
    companions = List.copyOf(companions);
  }

  /** All of them, those to begin with first. */
  public static List<Example> all() {
    return List.of(
        new Example("pick_and_place.script", Topic.MOTION, List.of()),
        new Example("palletizing.script", Topic.MOTION, List.of()),
        new Example("square_with_movel.script", Topic.MOTION, List.of()),
        new Example("kinematics.script", Topic.MOTION, List.of()),
        new Example("conveyor.script", Topic.MOTION, List.of()),
        new Example("engrave.script", Topic.MOTION, List.of("flower.nc")),
        new Example("weigh_and_press.script", Topic.MOTION, List.of("table.scene.json")),
        new Example("grip_part.script", Topic.CELL, List.of("grip_part.scene.json")),
        new Example("belt_pick.script", Topic.CELL, List.of("belt_pick.scene.json")),
        new Example(
            "lift_casting.script",
            Topic.CELL,
            List.of("lift_casting.scene.json", "parts/casting.stl")),
        new Example("stack_vacuum.script", Topic.CELL, List.of("stack_vacuum.scene.json")),
        new Example("sort_parts.script", Topic.CELL, List.of("sort_parts.scene.json")),
        new Example("peg_in_hole.script", Topic.CELL, List.of("peg_in_hole.scene.json")),
        new Example("tend_machine.script", Topic.CELL, List.of("tend_machine.scene.json")),
        new Example(
            "handover_left.script",
            Topic.CELL,
            List.of("handover.scene.json", "handover_right.script", "handover_cell.script")),
        new Example("hello.script", Topic.LANGUAGE, List.of()),
        new Example("watch_input.script", Topic.LANGUAGE, List.of()),
        new Example("shared_counter.script", Topic.LANGUAGE, List.of()),
        new Example("job_queue.script", Topic.LANGUAGE, List.of()),
        new Example("statistics.script", Topic.LANGUAGE, List.of()),
        new Example("parse_message.script", Topic.LANGUAGE, List.of()),
        new Example("secondary.script", Topic.LANGUAGE, List.of()),
        new Example("stack_boxes.pendant", Topic.NODES, List.of("stack_boxes.pinst")));
  }

  /** What an action is called that opens it: its name in words. */
  String title() {
    return HelpViewTexts.text(
        "example", file.substring(0, file.lastIndexOf('.')).replace('_', ' '));
  }

  /** Id of that action. */
  String id() {
    return "example."
        + topic.name().toLowerCase(Locale.ROOT)
        + "."
        + file.substring(0, file.lastIndexOf('.')).replace('_', '-');
  }

  /** The meshes among its companions, which its scene names. */
  public ExampleMeshes meshes() {
    return new ExampleMeshes(companions.stream().filter(MeshFile::hasEnding).toList());
  }

  /** What a companion says. */
  public static String companion(String name) {
    return HelpTexts.read("examples/" + name);
  }

  /** What it says; an internal error if it is missing. */
  public String text() {
    return HelpTexts.read("examples/" + file);
  }
}
