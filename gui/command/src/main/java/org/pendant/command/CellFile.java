package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.CellPlan;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.layout.ArmEntry;
import org.pendant.controller.layout.NamedFile;
import org.pendant.controller.world.LinkContact;
import org.pendant.controller.world.MeshFiles;
import org.pendant.models.json.JsonException;

/**
 * Cell file: a scene in which several controllers work, with the programs that it names.
 *
 * @param name of the file
 * @param plan what is in it
 */
record CellFile(String name, CellPlan plan) {
  /**
   * A controller of the cell before it is switched on.
   *
   * @param name what signals and messages call it
   * @param program what it runs; empty for nothing
   * @param options how it is switched on
   * @param armless whether it is the one without an arm
   */
  record Member(
      String name, Optional<RunnableFile> program, ControllerOptions options, boolean armless) {}

  /** How a command switches controllers on. */
  interface Switching {
    /**
     * The options of a controller.
     *
     * @param installation what it is set up as, unless the command line says otherwise
     * @param robot id of its arm, unless these say otherwise
     */
    ControllerOptions options(Optional<Installation> installation, Optional<String> robot)
        throws UsageException;
  }

  /**
   * The cell of several controllers that a command line names as its scene; empty for one with one
   * controller and for none.
   *
   * @throws UsageException if the scene cannot be read
   */
  static Optional<CellFile> of(Arguments arguments) throws UsageException {
    Optional<String> scene = arguments.value(SimulationOptions.SCENE);
    return scene.isPresent()
        ? Optional.of(read(scene.get(), arguments.files())).filter(file -> !file.alone())
        : Optional.empty();
  }

  /** Reads the file of a scene, with one controller or several. */
  static CellFile read(String name, SourceFiles files) throws UsageException {
    Path file = files.path("theScene", name);
    try (InputStream in = Files.newInputStream(file)) {
      return new CellFile(
          name, CellPlan.read(name, in, MeshFiles.in(file.toAbsolutePath().getParent())));
    } catch (JsonException e) {
      throw UsageException.fromEnglish(e);
    } catch (IOException e) {
      throw SourceFiles.unreadable(name, e);
    }
  }

  /**
   * Refuses a scene of several controllers.
   *
   * @throws UsageException if the command line names one
   */
  static void refuse(Arguments arguments) throws UsageException {
    Optional<CellFile> cell = of(arguments);
    if (cell.isPresent()) {
      throw new UsageException(text("severalControllers", cell.get().name()));
    }
  }

  /** The same cell with links that stop or pass through. */
  CellFile withLinks(LinkContact links) {
    return new CellFile(
        name,
        new CellPlan(
            plan.fileName(), plan.scene().withLinks(links), plan.layout(), plan.equipment()));
  }

  /** Whether there is one controller alone. */
  boolean alone() {
    return plan.layout().alone();
  }

  /** What the cell is, for people. */
  String described() {
    int arms = plan.layout().arms().size();
    return arms > 1 ? text("severalArms", arms) : text("armAndScript");
  }

  /**
   * The programs that the cell names, in the order of its controllers.
   *
   * @throws UsageException if one cannot be read
   */
  List<RunnableFile> programs(Arguments arguments) throws UsageException {
    List<RunnableFile> programs = new ArrayList<>();
    for (ArmEntry arm : plan.layout().arms()) {
      if (arm.program().isPresent()) {
        programs.add(program(arm.program().get(), arguments));
      }
    }
    if (plan.layout().script().isPresent()) {
      programs.add(program(plan.layout().script().get(), arguments));
    }
    return programs;
  }

  /** The file of the cell's script; empty where there is none. */
  Optional<String> script() {
    return plan.layout().script().map(this::path);
  }

  private String path(NamedFile file) {
    return Path.of(name).resolveSibling(file.name()).toString();
  }

  private RunnableFile program(NamedFile file, Arguments arguments) throws UsageException {
    requireThere(file, "program");
    return RunnableFile.read(arguments, List.of(path(file))).getFirst();
  }

  private void requireThere(NamedFile file, String what) throws UsageException {
    if (!Files.isRegularFile(Path.of(path(file)))) {
      throw new UsageException(
          file.place().refusal(text("noFileBesideScene", what, file.name())).getMessage());
    }
  }

  /**
   * The controllers, in their order.
   *
   * @param switching how they are switched on
   * @param only what the only arm runs where the file names no arms
   * @throws UsageException if a file that it names cannot be read, or a controller cannot be as it
   *     says
   */
  List<Member> members(Arguments arguments, Switching switching, Optional<RunnableFile> only)
      throws UsageException {
    List<Member> members = new ArrayList<>();
    for (ArmEntry arm : plan.arms()) {
      Optional<RunnableFile> program =
          arm.program().isPresent() ? Optional.of(program(arm.program().get(), arguments)) : only;
      members.add(
          new Member(
              arm.name(),
              program,
              own(options(arm, program, switching, arguments), members.size()),
              false));
    }
    if (plan.layout().script().isPresent()) {
      members.add(
          new Member(
              plan.layout().names().getLast(),
              Optional.of(program(plan.layout().script().get(), arguments)),
              own(switching.options(Optional.empty(), Optional.empty()), members.size()),
              true));
    }
    return members;
  }

  private ControllerOptions options(
      ArmEntry arm, Optional<RunnableFile> program, Switching switching, Arguments arguments)
      throws UsageException {
    Optional<Installation> installation =
        arm.installation().isPresent()
            ? Optional.of(installation(arm.installation().get(), arguments))
            : program.flatMap(RunnableFile::installation);
    Optional<String> robot = arm.robot().or(() -> program.flatMap(RunnableFile::robot));
    ControllerOptions options = switching.options(installation, robot);
    if (arm.robot().isPresent() && !options.robotId().equals(arm.robot().get())) {
      throw new UsageException(
          arm.place()
              .refusal(text("otherArm", arm.name(), arm.robot().get(), options.robotId()))
              .getMessage());
    }
    return options;
  }

  private Installation installation(NamedFile file, Arguments arguments) throws UsageException {
    requireThere(file, "installation");
    return InstallationOption.read(path(file), arguments.files()).installation();
  }

  /**
   * What the command line says of inputs is for the first controller; each has noise of its own.
   */
  private static ControllerOptions own(ControllerOptions options, int number) {
    return number == 0
        ? options
        : options
            .withSeed(options.seed() + number)
            .withInputs(Map.of())
            .withSignals(List.of())
            .withEncoders(Map.of());
  }
}
