package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** The arm, its stops and the look of the window. */
@Tag("slow")
final class RobotWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  private final OpenWindow window = sharedWindow.window();

  @Test
  void heldButtonTurnsAJointAndLettingGoStopsIt() {
    window.click("rail-move");
    window.awaitShown("move-joint-base");
    String before = window.words("move-joint-base");
    window.hold("move-base-up");
    window.await("the base turns", () -> !window.words("move-joint-base").equals(before));
    window.release();
    awaitRest();
    String rest = window.words("move-joint-base");
    assertNotEquals(before, rest);
  }

  @Test
  void freedriveIsOnAsLongAsItsButtonIsHeld() {
    window.click("rail-move");
    window.awaitWords("move-freedrive-status", "Freedrive is off.");
    window.hold("move-freedrive");
    window.awaitWords("move-freedrive-status", "Freedrive is on.");
    window.release();
    window.awaitWords("move-freedrive-status", "Freedrive is off.");
  }

  /** Two readings with half a second of robot time between them. */
  private void awaitRest() {
    window.await(
        "the base rests",
        () -> {
          String position = window.words("move-joint-base");
          double timeS = timeS();
          window.await("time goes by", () -> timeS() > timeS + 0.2);
          return position.equals(window.words("move-joint-base"));
        });
  }

  private double timeS() {
    return Double.parseDouble(window.words("robot-time").replace(" s", "").strip());
  }

  @Test
  void emergencyStopSwitchesOffAndTheArmComesBack() {
    window.click("rail-io");
    window.click("safety-emergency-stop");
    window.awaitWords("safety-mode", "mergency");
    window.click("rail-run");
    window.awaitShown("stop-card");
    window.click("rail-io");
    window.click("safety-emergency-stop");
    window.click("rail-run");
    makeReady();
    window.awaitHidden("stop-card");
  }

  @Test
  void protectiveStopIsExplainedAndUnlocked() {
    sharedWindow.program("sleep(0.1)", "protective_stop()", "sleep(1)");
    window.press("F5");
    window.awaitWords("safety-mode", "rotective stop");
    window.awaitWords("stop-card", "C209");
    window.awaitWords("stop-card", "The program asks for it");
    makeReady();
    window.awaitHidden("stop-card");
    window.awaitWords("safety-mode", "normal");
  }

  /** Does what the footer offers until the arm can run programs. */
  private void makeReady() {
    window.await(
        "the arm is ready",
        () -> {
          window.press("F4");
          return window.words("readiness").equals("Ready");
        });
  }

  @Test
  void anotherRobotIsSwitchedOn() {
    window.choose("robot", "UR10e");
    window.awaitWords("status-text", "UR10e");
    window.awaitWords("readiness", "Ready");
    window.choose("robot", "UR5e");
    window.awaitWords("status-text", "UR5e");
    window.awaitWords("readiness", "Ready");
  }

  @Test
  void speedOfProgramsFollowsKeysAndSlider() {
    window.press("control alt PAGE_DOWN");
    window.awaitWords("speed-value", "90 %");
    window.click("speed-slider");
    window.awaitFocus("speed-slider");
    window.press("END");
    window.awaitWords("speed-value", "100 %");
    window.press("LEFT");
    window.awaitWords("speed-value", "99 %");
    window.perform("Programs at full speed");
    window.awaitWords("speed-value", "100 %");
  }

  @Test
  void robotTimeIsPausedAndGoesOnByFrames() {
    window.choose("pace", "Paused");
    window.awaitEnabled("clock-step-frame");
    double pausedS = timeS();
    window.await(
        "frames go by",
        () -> {
          window.press("control shift F6");
          return timeS() > pausedS;
        });
    window.choose("pace", "Real time");
    window.awaitHidden("clock-step-frame");
  }

  @Test
  void coloursChangeInTheOpenWindow() {
    window.perform("Colours: Dark");
    window.await("the window is dark", () -> window.brightness("header") < 100);
    window.perform("Colours: Light");
    window.await("the window is light", () -> window.brightness("header") > 155);
    assertEquals("UR5e", window.words("robot"));
  }

  @Test
  void actionIsFoundByItsFirstLetters() {
    window.press("control shift P");
    window.awaitFocus("palette-query");
    window.type("show lo");
    window.awaitWords("palette-list", "Show Log");
    window.press("ENTER");
    window.awaitShown("log-view");
  }

  @Test
  void armIsDrawn() {
    window.awaitShown("scene");
    // A blank picture has one colour, a shaded arm on its ground has hundreds.
    window.await(
        "the arm is drawn, or it is said why not",
        () -> window.shows("scene-unavailable") || window.colours("scene") > 100);
    assumeFalse(
        window.shows("scene-unavailable"),
        () -> "no 3D here: " + window.words("scene-unavailable"));
  }

  @Test
  void aSceneIsOpenedAndTheStopByContactSaysWhatWasHit(@TempDir Path folder) throws IOException {
    Path scene = folder.resolve("bench.scene.json");
    Files.writeString(
        scene,
        "{\"objects\": [{\"type\": \"plane\", \"name\": \"bench\","
            + " \"point\": [0, 0, 0.4], \"normal\": [0, 0, 1]}]}");
    window.perform("Open scene");
    window.awaitFocus("open-dialog");
    window.type(scene + "\n");
    window.awaitWords("status-text", "Around the arm: bench.scene.json, 1 object");
    window.raise();
    window.click("rail-run");
    sharedWindow.run("movel(pose_add(get_target_tcp_pose(), p[0,0,-0.2,0,0,0]), v=0.5)");
    window.awaitWords("stop-card", "Tool touches");
    window.awaitWords("stop-card", "bench");
    window.perform("Close the scene");
    window.awaitWords("robot-change", "ends the program that runs");
    window.clickText("robot-change", "Change scene");
    window.awaitWords("status-text", "Nothing is around the arm");
    window.awaitHidden("stop-card");
  }
}
