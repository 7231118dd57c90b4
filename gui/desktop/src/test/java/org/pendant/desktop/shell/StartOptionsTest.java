package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.service.SimulationWishes;
import org.pendant.command.service.StartInstallation;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.session.RobotSession;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.settings.Settings;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmFile;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Calibration;
import org.pendant.models.json.JsonException;

/** The arm that the window begins with. */
final class StartOptionsTest {
  private static final String CONF =
      """
      delta_theta = [0.001, 0, 0, 0, 0, 0]
      delta_a = [0, 0, 0, 0, 0, 0]
      delta_d = [0.0004, 0, 0, 0, 0, 0]
      delta_alpha = [0, 0, 0, 0, 0, 0]
      """;
  private static final Settings UR3E_LAST_TIME =
      new MemorySettings(Map.of(RobotChange.ROBOT, "ur3e"));

  @TempDir private Path folder;

  private static SimulationWishes wishes(Optional<ArmDescription> arm, Optional<Path> calibration) {
    return new SimulationWishes(
        arm, calibration, Optional.empty(), Optional.empty(), Optional.empty(), List.of());
  }

  /** A UR10e with a heavier forearm. */
  private static ArmDescription ownArm() throws JsonException {
    String text = ArmFile.text(ArmLibrary.load("ur10e")).replaceFirst("3.989", "4.1");
    return ArmFile.read(
        "own.json", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
  }

  private Path calibration(String name) throws IOException {
    return Files.writeString(folder.resolve(name), CONF);
  }

  private Optional<StartInstallation> installation(String robot, String calibration) {
    return Optional.of(
        new StartInstallation(
            folder.resolve("cell.pinst"),
            Installation.NONE.with(
                parts -> {
                  parts.robot = robot;
                  parts.calibration = calibration;
                })));
  }

  @Test
  void theArmThatTheUserNamesTakesThePlaceOfThatOfLastTime() throws JsonException {
    StartOptions of =
        StartOptions.of(
            UR3E_LAST_TIME,
            Optional.empty(),
            false,
            wishes(Optional.of(ownArm()), Optional.empty()));

    assertEquals(ownArm(), of.controller().arm());
    assertEquals("ur10e", of.controller().robotId());
    assertNotEquals(ArmLibrary.load("ur10e"), of.controller().arm());
    assertEquals(List.of(), of.troubles());
  }

  @Test
  void aCalibrationThatTheUserNamesIsOfTheArmThatThereIs() throws IOException {
    Path file = calibration("calibration.conf");

    StartOptions of =
        StartOptions.of(
            UR3E_LAST_TIME, Optional.empty(), false, wishes(Optional.empty(), Optional.of(file)));

    assertEquals("ur3e", of.controller().robotId());
    assertNotEquals(Calibration.NONE, of.controller().arm().calibration());
    assertEquals(List.of(), of.troubles());
  }

  @Test
  void aCalibrationOfTheUserTakesThePlaceOfThatOfTheInstallation() throws IOException {
    Path file = calibration("calibration.conf");

    StartOptions of =
        StartOptions.of(
            UR3E_LAST_TIME,
            installation("ur10e", "none.conf"),
            true,
            wishes(Optional.empty(), Optional.of(file)));

    assertEquals("ur10e", of.controller().robotId());
    assertNotEquals(Calibration.NONE, of.controller().arm().calibration());
    assertEquals(List.of(), of.troubles());
  }

  @Test
  void theCalibrationOfAnInstallationStandsBesideIt() throws IOException {
    calibration("calibration.conf");

    StartOptions of =
        StartOptions.of(
            UR3E_LAST_TIME, installation("", "calibration.conf"), true, SimulationWishes.NONE);

    assertNotEquals(Calibration.NONE, of.controller().arm().calibration());
  }

  @Test
  void whatCannotBeUsedIsToldAndTheWindowOpensAllTheSame() {
    StartOptions of =
        StartOptions.of(
            UR3E_LAST_TIME,
            installation("ur16e", ""),
            false,
            wishes(Optional.empty(), Optional.of(folder.resolve("none.conf"))));

    assertEquals(ArmLibrary.load("ur3e"), of.controller().arm());
    assertEquals(2, of.troubles().size());
    assertTrue(of.troubles().getFirst().contains("it is for UR16e, the arm is UR3e"));
    assertEquals(
        "The calibration cannot be used: none.conf, there is no such file",
        of.troubles().getLast());
  }

  @Test
  void switchingOffAndOnKeepsTheArm() throws Exception {
    ControllerOptions options =
        StartOptions.of(
                UR3E_LAST_TIME,
                Optional.empty(),
                false,
                wishes(Optional.of(ownArm()), Optional.of(calibration("calibration.conf"))))
            .controller();
    CompletableFuture<String> told = new CompletableFuture<>();
    try (RobotSession session = RobotSession.start(options)) {
      new RobotChange(session, start -> {}, UR3E_LAST_TIME, new Notices(), told::complete, id -> {})
          .restart();

      assertEquals("The controller was switched off and on", told.get(60, TimeUnit.SECONDS));
      assertEquals(options.arm(), session.options().arm());
    }
  }
}
