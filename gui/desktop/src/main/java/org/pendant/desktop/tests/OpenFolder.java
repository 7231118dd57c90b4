package org.pendant.desktop.tests;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.models.arm.ArmDescription;

/** Open folder: where the tests of the program in front are, and the robot that they are for. */
final class OpenFolder {
  private final Programs programs;
  private final RobotSession session;
  private final ActiveInstallation installation;
  private final Predicate<String> known;
  private Optional<Path> folder = Optional.empty();
  private List<SavedProgram> saved = List.of();

  /**
   * The folder of the program in front.
   *
   * @param known whether a file, by its name below the folder, belongs to the tests that are shown:
   *     it may come to the front without its own folder taking their place
   */
  OpenFolder(
      Programs programs,
      RobotSession session,
      ActiveInstallation installation,
      Predicate<String> known) {
    this.programs = programs;
    this.session = session;
    this.installation = installation;
    this.known = known;
  }

  private Optional<Path> now() {
    Optional<Path> front = programs.current().file().map(file -> file.toAbsolutePath().normalize());
    if (folder.isPresent() && front.filter(this::isKnown).isPresent()) {
      return folder;
    }
    return front.map(Path::getParent);
  }

  private boolean isKnown(Path file) {
    return file.getRoot().equals(folder.orElseThrow().getRoot())
        && known.test(folder.orElseThrow().relativize(file).toString().replace('\\', '/'));
  }

  /**
   * Whether tests are to be looked for: the folder is another one, or a program was opened, closed
   * or saved.
   *
   * @param shown the folder of the tests that are shown
   * @param busy whether they run, so that only another folder matters now
   */
  boolean changed(Optional<String> shown, boolean busy) {
    if (!now().map(Path::toString).equals(shown)) {
      saved = onDisk();
      return true;
    }
    List<SavedProgram> written = onDisk();
    if (busy || same(written, saved)) {
      return false;
    }
    saved = written;
    return true;
  }

  private List<SavedProgram> onDisk() {
    return programs.all().stream().flatMap(each -> each.onDisk().stream()).toList();
  }

  /** Compares by identity: their texts are long, and each save makes a new one. */
  @SuppressWarnings("ReferenceEquality") // so it is meant
  private static boolean same(List<SavedProgram> one, List<SavedProgram> other) {
    if (one.size() != other.size()) {
      return false;
    }
    for (int i = 0; i < one.size(); i++) {
      if (one.get(i) != other.get(i)) {
        return false;
      }
    }
    return true;
  }

  /** Files and robot as they are now. */
  Optional<TestSetup> setup() {
    folder = now();
    return folder.map(where -> new TestSetup(new FolderFiles(where, edited()), robot()));
  }

  private Map<Path, byte[]> edited() {
    Map<Path, byte[]> edited = new HashMap<>();
    for (ProgramDocument each : programs.all()) {
      if (each.modified() && !each.readOnly() && isOurs(each)) {
        each.file()
            .ifPresent(
                file -> edited.put(file.toAbsolutePath().normalize(), each.source().bytes()));
      }
    }
    return edited;
  }

  /** Whether its text is what its file would have. */
  private static boolean isOurs(ProgramDocument document) {
    return !document.isTree() || document.name().endsWith(ProgramDocument.TREE);
  }

  /** The arm and the installation of the window; all else as {@code pendant test} has it. */
  private ControllerOptions robot() {
    ArmDescription arm = session.state().arm().description();
    ControllerOptions robot =
        ControllerOptions.headless()
            .withRobot(arm)
            .withCalibration(arm.calibration())
            .withScene(session.options().scene())
            .withEquipment(session.options().equipment());
    Installation used = installation.current();
    return InstallationCheck.refusal(used, arm).isEmpty() ? robot.withInstallation(used) : robot;
  }
}
