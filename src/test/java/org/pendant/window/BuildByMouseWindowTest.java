package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** A program made of nodes, from nothing, by the mouse alone. */
@Tag("slow")
final class BuildByMouseWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  private static final String TREE = "program-tree";
  private static final String PALETTE = "program-palette";

  private static final String PART_THERE = "Wait digital_in[0] \u225f True";
  private static final String PART_GONE = "Wait digital_in[0] \u225f False";
  private static final String CLOSE = "Set digital_out[3] = On";
  private static final String OPEN = "Set digital_out[3] = Off";

  private final OpenWindow window = sharedWindow.window();

  @Test
  void pickAndPlaceIsBuiltTaughtAndRun() {
    String start = window.words("run-joints-base");
    window.click("rail-program");
    window.click("program-empty-file-new");
    window.clickRow(TREE, "Robot Program");
    window.click("form-main-program-forever");

    teachPickHere();
    double placeDeg = teachPlaceByJogging();
    gripAndRelease();
    waitForThePartBeforeGripping();
    comeBackToThePick();
    window.awaitHidden("program-problems-bar");
    assertEquals(
        List.of(
            "Robot Program",
            "MoveJ",
            "Waypoint_1",
            PART_THERE,
            CLOSE,
            "Waypoint_2",
            PART_GONE,
            OPEN,
            "Waypoint_1"),
        labels());

    goToThePickByHolding(start);
    runWhatWasBuilt(start, placeDeg);
  }

  private void teachPickHere() {
    window.clickRow(PALETTE, "Waypoint");
    window.clickRow(TREE, "Waypoint_1");
    window.awaitWords("program-problems-bar", "1 thing to complete");
    window.click("form-waypoint-position-here");
    window.awaitHidden("program-problems-bar");
  }

  /** Gives back what the base joint reads there. */
  private double teachPlaceByJogging() {
    window.clickRow(PALETTE, "Waypoint");
    window.awaitWords(TREE, "Waypoint_2");
    window.click("form-waypoint-position-teach");
    window.awaitShown("teach-bar");
    double beforeDeg = joggedDeg();
    window.hold("move-base-up");
    window.await("the base turns", () -> Math.abs(joggedDeg() - beforeDeg) > 2);
    window.release();
    window.awaitTime(0.5);
    double placeDeg = joggedDeg();
    window.click("teach-ok");
    window.awaitShown(TREE);
    window.awaitHidden("program-problems-bar");
    return placeDeg;
  }

  private double joggedDeg() {
    return Double.parseDouble(window.words("move-joint-base"));
  }

  private void gripAndRelease() {
    window.clickRow(TREE, "Waypoint_1");
    setOutput("true");
    window.clickRow(TREE, "Waypoint_2");
    window.clickRow(PALETTE, "Wait");
    window.click("form-wait-what-digital");
    window.click("form-wait-what.level-false");
    window.awaitWords(TREE, PART_GONE);
    setOutput("false");
  }

  private void setOutput(String level) {
    window.clickRow(PALETTE, "Set");
    window.pick("form-set-setting", "Digital output");
    window.pick("form-set-setting.signal", "digital_out[3]");
    window.click("form-set-setting.level-" + level);
  }

  /** It is added at the end, and dragged to where it belongs. */
  private void waitForThePartBeforeGripping() {
    window.clickRow(PALETTE, "Wait");
    window.click("form-wait-what-digital");
    window.awaitWords(TREE, PART_THERE);
    window.dragRow(TREE, PART_THERE, TREE, "Waypoint_1");
  }

  /** The third waypoint is dragged from the palette, and shares the place of the first. */
  private void comeBackToThePick() {
    window.dragRow(PALETTE, "Waypoint", TREE, OPEN);
    window.awaitWords(TREE, "Waypoint_3");
    window.pick("form-waypoint-position", "Waypoint_1");
    window.await("the place is shared", () -> !window.words(TREE).contains("Waypoint_3"));
  }

  private List<String> labels() {
    return window.words(TREE).lines().map(line -> line.split(", ", 3)[1]).toList();
  }

  /** How long it takes depends on how far the arm has been jogged. */
  private void goToThePickByHolding(String start) {
    window.await(
        "the arm is there",
        () -> {
          window.click("rail-program");
          window.hold("form-waypoint-position-go");
          window.awaitTime(2);
          window.release();
          window.click("rail-run");
          return window.words("run-joints-base").equals(start);
        });
  }

  private double baseDeg() {
    return Double.parseDouble(window.words("run-joints-base").replace("\u00b0", ""));
  }

  private void runWhatWasBuilt(String start, double placeDeg) {
    window.click("program-run");
    window.awaitWords("program-state", "running");
    window.click("rail-io");
    window.awaitShown("digital-out-3");
    assertFalse(window.selected("digital-out-3"));
    window.click("digital-in-0");
    window.await("the gripper closes", () -> window.selected("digital-out-3"));
    window.click("rail-run");
    // The screens round the position to different places.
    window.await("the arm is at the place", () -> Math.abs(baseDeg() - placeDeg) < 0.02);
    window.click("rail-io");
    window.click("digital-in-0");
    window.await("the gripper opens", () -> !window.selected("digital-out-3"));
    window.click("rail-run");
    window.awaitWords("program-state", "stopped");
    window.awaitWords("run-joints-base", start);
    window.click("rail-log");
    window.awaitShown("log-table");
    assertEquals(
        List.of(),
        window
            .words("log-table")
            .lines()
            .filter(line -> !line.isBlank() && !line.contains("this computer could not keep up"))
            .filter(line -> !line.contains("| Robot |"))
            .toList(),
        "nothing went wrong but what a slow computer does");
  }
}
