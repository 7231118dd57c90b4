package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.service.DesktopLauncher;
import org.pendant.command.service.PortWishes;
import org.pendant.command.service.RobotAccess;
import org.pendant.command.service.SimulationWishes;
import org.pendant.command.service.StartInstallation;
import org.pendant.models.arm.ArmFile;
import org.pendant.models.arm.ArmLibrary;

final class OpenCommandTest {
  private static final String CONF =
      """
      delta_theta = [0.001, 0, 0, 0, 0, 0]
      delta_a = [0, 0, 0, 0, 0, 0]
      delta_d = [0.0004, 0, 0, 0, 0, 0]
      delta_alpha = [0, 0, 0, 0, 0, 0]
      """;
  private static final DesktopServices NO_DESKTOP =
      new DesktopServices(Optional::empty, Optional::empty);

  @TempDir private Path folder;

  /** Keeps what it is asked to open. */
  private static final class KeepingLauncher implements DesktopLauncher {
    private List<Path> files = List.of();
    private Optional<StartInstallation> installation = Optional.empty();
    private SimulationWishes wishes = SimulationWishes.NONE;
    private boolean access;

    @Override
    public void open(
        List<Path> files,
        Optional<PortWishes> ports,
        Optional<StartInstallation> installation,
        SimulationWishes wishes,
        Optional<RobotAccess> access) {
      this.access = access.isPresent();
      this.files = files;
      this.installation = installation;
      this.wishes = wishes;
    }

    @Override
    public void train(Path program) {
      throw new AssertionError("no command trains");
    }
  }

  /** What the desktop is asked for by a command line that it takes. */
  private static KeepingLauncher opened(String... words) {
    KeepingLauncher launcher = new KeepingLauncher();
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    ExitCode code =
        new Pendant(
                new Console(new ByteArrayOutputStream(), errors),
                new DesktopServices(() -> Optional.of(launcher), Optional::empty))
            .run(List.of(words));
    assertEquals(ExitCode.DONE, code, () -> errors.toString(StandardCharsets.UTF_8));
    return launcher;
  }

  private String write(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text).toString();
  }

  @Test
  void asksForTheArmAndItsCalibration() throws IOException {
    String own = write("own.json", ArmFile.text(ArmLibrary.load("ur10e")));
    String conf = write("calibration.conf", CONF);

    SimulationWishes wishes = opened("--robot", own, "--calibration", conf).wishes;
    assertEquals(Optional.of(ArmLibrary.load("ur10e")), wishes.arm());
    assertEquals(Optional.of(Path.of(conf)), wishes.calibration());
    SimulationWishes byName = opened("open", "--robot", "UR3e").wishes;
    assertEquals(Optional.of(ArmLibrary.load("ur3e")), byName.arm());
    assertEquals(SimulationWishes.NONE, opened("open", "a.script").wishes);
  }

  @Test
  void theCalibrationOfAnInstallationIsLookedForBesideItOnce() throws IOException {
    String cell =
        write(
            "cell.pinst", "pendant installation 1\nrobot id=\"ur10e\" calibration=\"arm.conf\"\n");

    StartInstallation start = opened("open", "--installation", cell).installation.orElseThrow();
    assertEquals("arm.conf", start.installation().calibration());
  }

  @Test
  void asksForAScene() throws IOException {
    String scene = write("cell.scene.json", "{}");

    assertEquals(Optional.of(Path.of(scene)), opened("open", "--scene", scene).wishes.scene());
    String wrong = write("wrong.scene.json", "{\"object\": []}");
    assertTrue(
        complaint("open", "--scene", wrong).startsWith("pendant open: " + wrong + ":1:2: "),
        complaint("open", "--scene", wrong));
  }

  @Test
  void asksForDevicesBesidesThoseOfTheScene() throws IOException {
    assertEquals(
        List.of("two-finger", "rg"),
        opened("open", "--device", "two-finger", "--device", "rg").wishes.devices());
    assertEquals(List.of("2fg"), opened("--device", "2fg").wishes.devices());
    String scene = write("cell.scene.json", "{\"devices\": [{\"type\": \"rg\"}]}");
    assertEquals(
        "pendant open: --device: name is \"rg\" again, must be another for each device",
        complaint("open", "--scene", scene, "--device", "rg"));
    assertTrue(
        complaint("open", "--device", "hand").startsWith("pendant open: --device is 'hand'"),
        complaint("open", "--device", "hand"));
  }

  @Test
  void givesEditorsAccessWhereThatIsAskedFor() throws IOException {
    int port = AttachPortTest.freePort();
    assertTrue(opened("open", "--dap", String.valueOf(port)).access);
    assertFalse(opened("open").access);
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      assertTrue(
          complaint("open", "--dap", String.valueOf(taken.getLocalPort()))
              .contains("--dap: port " + taken.getLocalPort() + " cannot be opened"));
    }
  }

  @Test
  void aFileAloneIsOpened() throws IOException {
    for (String name :
        List.of("a.script", "b.pendant", "c.urp", "d.pinst", "e.installation", "f.scene.json")) {
      String file = write(name, "");
      assertEquals(List.of(Path.of(file)), opened(file).files);
    }
  }

  @Test
  void optionsMayFollowAFileThatIsOpened() throws IOException {
    KeepingLauncher launcher = opened(write("a.script", ""), "--robot", "ur3e");
    assertEquals(Optional.of(ArmLibrary.load("ur3e")), launcher.wishes.arm());
  }

  @Test
  void aRecordingIsOpenedWhetherItIsThereOrNot() {
    assertEquals(List.of(Path.of("gone.rec").toAbsolutePath()), opened("gone.rec").files);
  }

  @Test
  void whatIsNeitherFileNorCommandIsRefused() {
    assertEquals(
        "pendant: gone.script: there is no such file, and no command of that name",
        complaint("gone.script"));
    assertEquals("pendant: unknown command rum, did you mean run?", complaint("rum"));
    assertEquals("pendant: unknown command quite-another", complaint("quite-another"));
    assertEquals(
        "pendant: " + folder + " is a directory, expected a file or a command",
        complaint(folder.toString()));
  }

  /** The first line about a command line that is wrong. */
  private static String complaint(String... words) {
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    ExitCode code =
        new Pendant(new Console(new ByteArrayOutputStream(), errors), NO_DESKTOP)
            .run(List.of(words));
    assertEquals(ExitCode.WRONG_USAGE, code);
    return errors.toString(StandardCharsets.UTF_8).lines().findFirst().orElseThrow();
  }

  @Test
  void refusesAnArmThatItCannotHave() throws IOException {
    String cell = write("cell.pinst", "pendant installation 1\nrobot id=\"ur10e\"\n");
    String conf = write("calibration.conf", CONF.replace("0.0004", "0.04"));

    assertTrue(refusal("--robot", "ur4").contains("must be one of"));
    assertTrue(
        refusal("--robot", "ur3e", "--installation", cell)
            .endsWith("it is for UR10e, the arm is UR3e"));
    assertTrue(refusal("--robot", "ur3e", "--calibration", conf).contains("from where a UR3e has"));
    assertTrue(
        refusal("--installation", cell, "--calibration", conf).contains("from where a UR10e has"));
    assertTrue(refusal("--calibration", "arm.txt").contains("must end in .yaml"));
    assertEquals("none.conf: there is no such file", refusal("--calibration", "none.conf"));
  }

  private static String refusal(String... words) {
    OpenCommand command = new OpenCommand(NO_DESKTOP);
    Console console = new Console(new ByteArrayOutputStream(), new ByteArrayOutputStream());
    return assertThrows(
            UsageException.class,
            () -> command.run(Arguments.parse(command.options(), List.of(words)), console))
        .getMessage();
  }

  @Test
  void refusesAnAddressWithoutPorts() {
    assertEquals(
        "--host is only for open ports, with --ports", refusal("--host", "127.0.0.1", "a.script"));
  }

  @Test
  void refusesAnOffsetThatLeavesNoRoom() {
    assertEquals(
        "--port-offset is 11215, must be a number from 0 to 11214",
        refusal("--ports", "--port-offset", "11215"));
  }

  @Test
  void aGoldenRecordingIsLedToWhatMakesItOneThatCanBeOpened() throws IOException {
    String golden = write("pick.golden", "Pendant golden recording, version 1\n");

    assertTrue(
        refusal(golden).contains("pendant convert " + golden + " FILE.rec"), () -> refusal(golden));
  }

  @Test
  void refusesAFolderThatIsNotThere() {
    assertTrue(
        refusal("--ports", "--programs", "no/such/folder").endsWith("folder, must be a folder"));
  }

  @Test
  void itsOptionsAreUnderstoodWithoutItsName() {
    assertTrue(OpenCommand.understands("--ports"));
    assertTrue(OpenCommand.understands("--host=127.0.0.1"));
    assertFalse(OpenCommand.understands("--seed"));
    assertFalse(OpenCommand.understands("open"));
  }

  @Test
  void saysThatThereIsNoDesktop() {
    ByteArrayOutputStream errors = new ByteArrayOutputStream();

    ExitCode code =
        new Pendant(new Console(new ByteArrayOutputStream(), errors), NO_DESKTOP)
            .run(List.of("open", "a.script"));

    assertEquals(ExitCode.WRONG_USAGE, code);
    assertEquals(
        """
        pendant: the desktop cannot be opened: it is not on the class path
        Programs run without a display too: pendant run FILE...; pendant --help lists more
        """,
        errors.toString(StandardCharsets.UTF_8));
  }
}
