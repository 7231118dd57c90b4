package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.project.program.text.ProgramText;
import org.pendant.project.program.text.ReadProgram;

/** A program made of nodes, from nothing to the file and back, by the keyboard alone. */
@Tag("slow")
final class BuildByKeysWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  private static final String TREE = "program-tree";
  private static final List<String> BUILT =
      List.of(
          "Robot Program",
          "MoveJ",
          "Waypoint_1",
          "Set digital_out[3] = On",
          "Wait: 0.2",
          "Waypoint_2",
          "Set digital_out[4] = On",
          "textmsg(\"placed it\")");

  private final OpenWindow window = sharedWindow.window();

  @TempDir Path folder;

  @Test
  void pickAndPlaceIsBuiltSavedOpenedAgainAndRun() throws IOException {
    Path file = folder.resolve("cell.pendant");
    build();
    assertEquals(BUILT, labels());
    save(file);
    ReadProgram saved = ProgramText.read(Files.readString(file));
    assertEquals(List.of(), saved.problems());
    assertEquals(
        Math.toRadians(20), saved.tree().waypoints().get("Waypoint_2").jointsRad().get(0), 1e-9);

    window.press("control W");
    window.await("it is closed", () -> !window.words("program-name").contains("cell"));
    window.press("control O");
    window.awaitFocus("open-dialog");
    window.type(file + "\n");
    window.awaitWords("program-name", "cell.pendant");
    window.awaitHidden("open-dialog");
    window.raise();
    window.perform("Show Program");
    window.awaitShown(TREE);
    assertEquals(BUILT, labels());
    run();
  }

  private void build() {
    window.press("control N");
    window.perform("Show Program");
    window.perform("Go to the tree");
    window.awaitFocus(TREE);
    window.press("ENTER");
    window.tabTo("form-main-program-forever");
    window.press("SPACE");

    add("Waypoint");
    // From the move to its waypoint, and to the form of that.
    window.press("RIGHT");
    window.press("ENTER");
    window.tabTo("form-waypoint-position-here");
    window.press("SPACE");
    window.awaitHidden("program-problems-bar");

    add("Wait");
    window.typeInto("form-wait-what.timeS", "0.2");
    add("Waypoint");
    window.tabTo("form-waypoint-position-here");
    window.press("SPACE");
    window.typeInto("form-waypoint-joint-0", "20");
    setOutput("digital_out[4]");
    add("Script line");
    window.press("ENTER");
    window.tabTo("form-script-line-code");
    window.type("textmsg(\"placed it\")");
    window.awaitWords(TREE, "textmsg(\"placed it\")");
    // The gripper closes first: four lines up.
    setOutput("digital_out[3]");
    window.perform("Go to the tree");
    window.awaitFocus(TREE);
    for (int i = 0; i < 4; i++) {
      window.press("alt UP");
    }
    window.await("it is where it belongs", () -> BUILT.equals(labels()));
  }

  /** Adds a node behind the selected one and goes to its form. */
  private void add(String kind) {
    window.perform("Go to the tree");
    window.awaitFocus(TREE);
    window.perform("Add: " + kind);
    window.awaitFocus(TREE);
  }

  private void setOutput(String output) {
    add("Set");
    window.press("ENTER");
    window.arrowTo("form-set-setting", "Digital output");
    window.arrowTo("form-set-setting.signal", output);
    window.awaitWords(TREE, "Set " + output + " = On");
  }

  private void save(Path file) {
    window.press("control S");
    window.awaitFocus("save-dialog");
    window.press("control A");
    window.type(file + "\n");
    window.awaitHidden("save-dialog");
    window.await("it is saved", () -> window.words("program-name").equals("cell.pendant"));
    window.raise();
    assertTrue(Files.exists(file));
  }

  private List<String> labels() {
    return window.words(TREE).lines().map(line -> line.split(", ", 3)[1]).toList();
  }

  private void run() {
    window.press("F5");
    window.perform("Show Run");
    window.awaitWords("run-joints-base", "20.00");
    window.awaitWords("program-state", "stopped");
    window.perform("Show Program");
    window.awaitWords(TREE, "% of the cycle");
    window.perform("Show I/O");
    window.awaitShown("digital-out-3");
    window.await("the gripper closed", () -> window.selected("digital-out-3"));
    window.await("the part is there", () -> window.selected("digital-out-4"));
    window.perform("Show Log");
    window.awaitWords("log-table", "placed it");
    theWorstMomentIsThatOfANode();
  }

  /** People who build programs of nodes know no lines of the script. */
  private void theWorstMomentIsThatOfANode() {
    window.perform("Show Program");
    window.perform("Timeline: to the worst moment before");
    window.perform("Show Motion");
    window.awaitWords("motion-text", " Waypoint_2: movej(");
    window.awaitWords("motion-text", "s, node ");
    window.perform("Timeline: back to now");
  }
}
