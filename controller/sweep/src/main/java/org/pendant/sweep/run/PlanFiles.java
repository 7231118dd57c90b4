package org.pendant.sweep.run;

import static org.pendant.sweep.run.SweepRunTexts.text;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;
import org.pendant.controller.installation.InstallationProblem;
import org.pendant.controller.io.SignalText;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.world.MeshFiles;
import org.pendant.controller.world.MeshPart;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneReader;
import org.pendant.language.source.Source;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmFile;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.calibration.CalibrationTrouble;
import org.pendant.models.json.JsonException;
import org.pendant.project.calibration.ArmCalibration;
import org.pendant.project.installation.file.InstallationFile;
import org.pendant.project.installation.file.InstallationTrouble;
import org.pendant.project.program.file.BrokenTree;
import org.pendant.project.program.file.TreeFile;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.sweep.plan.ParameterRange;
import org.pendant.sweep.plan.ParameterTarget;
import org.pendant.sweep.plan.ParameterValue;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.SweepParameter;
import org.pendant.sweep.plan.SweepPlan;

/** Plan files: reads what a plan names, as seen from its folder. */
final class PlanFiles {
  /** Far above any real one. */
  private static final int MAX_BYTES = 32 << 20;

  private final SweepPlan plan;
  private final Path folder;
  private final SortedMap<String, byte[]> read = new TreeMap<>();

  PlanFiles(SweepPlan plan, Path folder) {
    this.plan = plan;
    this.folder = folder;
  }

  /** All that was read, by name. */
  SortedMap<String, byte[]> read() {
    return read;
  }

  /** Reads everything. */
  JobInputs inputs() throws PlanException {
    Optional<Installation> named = Optional.empty();
    if (plan.installation().isPresent()) {
      named = Optional.of(installation(plan.installation().get()));
    }
    Source program;
    Optional<ProgramNodes> nodes = Optional.empty();
    Optional<String> made = Optional.empty();
    Optional<Installation> installation = named;
    byte[] bytes = bytes("program", plan.program());
    if (TreeFile.hasEnding(plan.program())) {
      TreeFile tree = tree(bytes, named);
      GeneratedScript script = tree.script();
      program = Source.of(tree.scriptName(), script.text());
      nodes = Optional.of(new ProgramNodes(tree.tree(), script));
      installation = Optional.of(tree.installation());
      made = tree.robot();
    } else {
      program = Source.of(plan.program(), bytes);
    }
    Optional<String> installed =
        installation.map(Installation::robot).filter(robot -> !robot.isEmpty());
    String robot =
        plan.robot().or(() -> installed).orElse(made.orElse(ControllerOptions.DEFAULT_ROBOT));
    Map<String, ArmDescription> arms = new HashMap<>();
    for (String each : robots(robot)) {
      ArmDescription arm = arm(each, installation);
      if (installation.isPresent()) {
        refuseUnlessFor(installation.get(), arm);
      }
      arms.put(each, arm);
    }
    return new JobInputs(
        plan,
        program,
        nodes,
        ProgramsFolder.of(path(plan.program()).toString()),
        robot,
        arms,
        installation,
        scene(),
        equipment(),
        signals());
  }

  private PlanException wrong(String message) {
    return new PlanException(plan.name() + ": error: " + message);
  }

  private Path path(String name) throws PlanException {
    try {
      return folder.resolve(name);
    } catch (InvalidPathException e) {
      throw wrong(text("noFileName", name, e.getReason()));
    }
  }

  private byte[] bytes(String key, String name) throws PlanException {
    try (InputStream in = Files.newInputStream(path(name))) {
      byte[] bytes = in.readNBytes(MAX_BYTES + 1);
      if (bytes.length > MAX_BYTES) {
        throw wrong(text("fileTooLong", key, name, MAX_BYTES));
      }
      read.put(name, bytes);
      return bytes;
    } catch (IOException e) {
      throw wrong(key + " " + name + ": " + FileTrouble.reason(e));
    }
  }

  private Installation installation(String name) throws PlanException {
    byte[] bytes = bytes("installation", name);
    Optional<String> variables =
        InstallationFile.variablesOf(name)
            .filter(each -> Files.isRegularFile(folder.resolve(each)));
    Optional<byte[]> values =
        variables.isPresent() ? Optional.of(bytes("variables", variables.get())) : Optional.empty();
    try {
      return InstallationFile.read(name, bytes, values).installation();
    } catch (InstallationTrouble e) {
      throw wrong(e.getMessage());
    }
  }

  private TreeFile tree(byte[] bytes, Optional<Installation> named) throws PlanException {
    try {
      TreeFile tree = TreeFile.read(plan.program(), bytes);
      Optional<Installation> wanted = named;
      String beside = tree.tree().installation();
      if (wanted.isEmpty() && !beside.isEmpty()) {
        for (String each : InstallationFile.namesOf(beside)) {
          Path file = path(plan.program()).resolveSibling(each);
          if (wanted.isEmpty() && Files.isRegularFile(file)) {
            wanted = Optional.of(installation(folder.relativize(file).toString()));
          }
        }
      }
      TreeFile whole = wanted.map(tree::in).orElse(tree);
      if (!whole.problems().isEmpty()) {
        throw new PlanException(whole.problems());
      }
      if (whole.waitingNodes() > 0) {
        throw wrong(text("partFromDriver", plan.program()));
      }
      return whole;
    } catch (BrokenTree e) {
      throw new PlanException(e.reports());
    }
  }

  /** The names of all arms that variants have. */
  private List<String> robots(String standard) throws PlanException {
    List<String> all = new ArrayList<>(List.of(standard));
    for (SweepParameter each : plan.parameters()) {
      if (each.target() instanceof ParameterTarget.RobotModel
          && each.range() instanceof ParameterRange.Listed(var values)) {
        values.stream().map(ParameterValue::text).forEach(all::add);
      }
    }
    return all;
  }

  private ArmDescription arm(String name, Optional<Installation> installation)
      throws PlanException {
    ArmDescription arm;
    if (name.toLowerCase(Locale.ROOT).endsWith(".json")) {
      try {
        arm = ArmFile.read(name, new ByteArrayInputStream(bytes("robot", name)));
      } catch (JsonException e) {
        throw new PlanException(e.getMessage());
      }
    } else {
      String id =
          ArmLibrary.find(name)
              .orElseThrow(
                  () -> wrong(text("unknownRobot", name, String.join(", ", ArmLibrary.ids()))));
      arm = ArmLibrary.load(id);
    }
    String calibration = installation.map(Installation::calibration).orElse("");
    if (calibration.isEmpty()) {
      return arm;
    }
    try {
      return arm.withCalibration(
          ArmCalibration.read(calibration, bytes("calibration", calibration), arm));
    } catch (CalibrationTrouble e) {
      throw wrong(e.getMessage());
    }
  }

  private void refuseUnlessFor(Installation installation, ArmDescription arm) throws PlanException {
    Optional<InstallationProblem> refusal = InstallationCheck.refusal(installation, arm);
    if (refusal.isPresent()) {
      throw wrong(text("installationUnusable", refusal.get()));
    }
  }

  private Scene scene() throws PlanException {
    if (plan.scene().isEmpty()) {
      return Scene.EMPTY;
    }
    String name = plan.scene().get();
    Path within = path(name).toAbsolutePath().getParent();
    try {
      Scene scene =
          SceneReader.read(
              name, new ByteArrayInputStream(bytes("scene", name)), MeshFiles.in(within));
      for (MeshPart mesh : scene.meshes()) {
        meshes(name, within, mesh.file());
      }
      return scene;
    } catch (JsonException e) {
      throw new PlanException(e.getMessage());
    }
  }

  /** Another mesh is another cell: what it is made of counts like the scene that names it. */
  private void meshes(String scene, Path within, String file) throws PlanException {
    try {
      for (String each : MeshFiles.named(within, file)) {
        bytes("mesh", Path.of(scene).resolveSibling(each).toString().replace('\\', '/'));
      }
    } catch (IOException e) {
      throw wrong(text("mesh", file, e.getMessage()));
    }
  }

  private CellEquipment equipment() throws PlanException {
    if (plan.scene().isEmpty()) {
      return CellEquipment.NONE;
    }
    String name = plan.scene().get();
    try {
      CellEquipment equipment =
          EquipmentReader.read(name, new ByteArrayInputStream(bytes("scene", name)));
      if (equipment.controllers().size() > 1) {
        throw new PlanException(text("severalControllers", name));
      }
      return equipment;
    } catch (JsonException e) {
      throw new PlanException(e.getMessage());
    }
  }

  private List<SignalWrite> signals() {
    List<SignalWrite> writes = new ArrayList<>();
    for (String each : plan.settings().inputs()) {
      int equals = each.indexOf('=');
      writes.addAll(SignalText.input(each.substring(0, equals), each.substring(equals + 1)));
    }
    return writes;
  }
}
