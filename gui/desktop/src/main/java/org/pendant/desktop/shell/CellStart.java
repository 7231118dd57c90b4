package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.command.service.SimulationWishes;
import org.pendant.command.service.StartInstallation;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.layout.ArmEntry;
import org.pendant.controller.layout.NamedFile;
import org.pendant.desktop.session.CellSetup;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.session.SceneFile;
import org.pendant.kit.settings.Settings;
import org.pendant.kit.text.Messages;
import org.pendant.models.arm.ArmLibrary;

/**
 * Cell start: all that a scene with several controllers needs to be switched on, read from the
 * files that it names.
 *
 * @param named the file that each controller runs, by its name, in the order of the scene
 * @param programs what is in these, in the same order, where the scene is a file
 * @param installations what each arm is set up as, by its name, where that is a file of ours
 * @param troubles what could not be used, in words for people
 */
record CellStart(
    CellSetup setup,
    Map<String, String> named,
    Map<String, SavedProgram> programs,
    Map<String, SavedProgram> installations,
    List<String> troubles) {
  CellStart {
    named = Collections.unmodifiableMap(new LinkedHashMap<>(named));
    programs = Collections.unmodifiableMap(new LinkedHashMap<>(programs));
    installations = Map.copyOf(installations);
    troubles = List.copyOf(troubles);
  }

  /**
   * Reads the files that a scene names; not for the dispatch thread.
   *
   * @param settings what the user has chosen last
   * @throws IOException if one cannot be read, with its place in the scene
   */
  static CellStart of(SceneFile scene, Settings settings) throws IOException {
    Reading reading = new Reading(scene, settings);
    for (ArmEntry arm : scene.plan().arms()) {
      reading.arm(arm);
    }
    if (scene.plan().layout().script().isPresent()) {
      reading.script(scene.plan().layout().script().get());
    }
    return new CellStart(
        new CellSetup(scene.plan(), reading.options),
        reading.named,
        reading.programs,
        reading.installations,
        reading.troubles);
  }

  /** What has been read so far. */
  private static final class Reading {
    private final SceneFile scene;
    private final Settings settings;
    private final List<ControllerOptions> options = new ArrayList<>();
    private final Map<String, String> named = new LinkedHashMap<>();
    private final Map<String, SavedProgram> programs = new LinkedHashMap<>();
    private final Map<String, SavedProgram> installations = new HashMap<>();
    private final List<String> troubles = new ArrayList<>();

    Reading(SceneFile scene, Settings settings) {
      this.scene = scene;
      this.settings = settings;
    }

    void arm(ArmEntry arm) throws IOException {
      Optional<StartInstallation> installation = Optional.empty();
      if (arm.installation().isPresent()) {
        NamedFile named = arm.installation().get();
        Path file = beside(named);
        try {
          installation =
              Optional.of(new StartInstallation(file, InstallationFiles.load(file).installation()));
          if (InstallationFiles.isOurs(file)) {
            installations.put(arm.name(), SavedProgram.read(file));
          }
        } catch (IOException e) {
          throw refusal(named, e);
        }
      }
      StartOptions start =
          StartOptions.of(
              settings,
              installation,
              installation.isPresent() && arm.robot().isEmpty(),
              wishes(arm));
      start.troubles().forEach(each -> troubles.add(Messages.told(arm.name(), each)));
      add(start.controller());
      if (arm.program().isPresent()) {
        program(arm.name(), arm.program().get());
      }
    }

    private static SimulationWishes wishes(ArmEntry arm) {
      return new SimulationWishes(
          arm.robot().map(ArmLibrary::load),
          Optional.empty(),
          Optional.empty(),
          Optional.empty(),
          Optional.empty(),
          List.of());
    }

    void script(NamedFile script) throws IOException {
      add(StartOptions.of(settings, Optional.empty(), false, SimulationWishes.NONE).controller());
      program(scene.plan().layout().names().getLast(), script);
    }

    /** Each has noise of its own. */
    private void add(ControllerOptions of) {
      options.add(of.withSeed(of.seed() + options.size()));
    }

    /** A scene that is no file names programs that people have open, or none. */
    private void program(String controller, NamedFile file) throws IOException {
      named.put(controller, file.name());
      if (scene.path().isPresent()) {
        try {
          programs.put(controller, SavedProgram.read(beside(file)));
        } catch (IOException e) {
          throw refusal(file, e);
        }
      }
    }

    private Path beside(NamedFile named) throws IOException {
      Optional<Path> file = scene.path();
      if (file.isEmpty()) {
        throw new IOException(
            named.place().refusal(text("isBesideNoFileSaveThe", named.name())).getMessage());
      }
      return file.get().resolveSibling(named.name());
    }

    private static IOException refusal(NamedFile named, IOException why) {
      return new IOException(
          named.place().refusal("\"" + named.name() + "\": " + why.getMessage()).getMessage(), why);
    }
  }
}
