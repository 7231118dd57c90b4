package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyConfigurationReader;
import org.pendant.controller.world.MeshFiles;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneReader;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.json.JsonException;

/** Simulation options: say which arm simulation is used, what is around it and what limits it. */
final class SimulationOptions {
  private static final double MAX_NOISE_RAD = 0.01;

  static final Option SCENE =
      Option.input("--scene", "FILE.json")
          .documented(
              "scene.json",
              "what the arm can touch and what truly hangs on its flange, see"
                  + " [scene.md](scene.md)");
  static final Option DEVICE =
      Option.of("--device", new OptionArgument.Choice(DeviceSetup.KINDS))
          .repeated()
          .documented(
              "two-finger",
              "something that answers the program in robot time, besides what the scene has: "
                  + String.join(
                      ", ", DeviceSetup.KINDS.stream().map(each -> "`" + each + "`").toList())
                  + "; may be repeated, see [devices.md](devices.md)");
  private static final Option SAFETY =
      Option.input("--safety", "FILE.json")
          .documented(
              "safety.json",
              "safety limits, planes and tool direction in place of the standard ones, see"
                  + " [safety.md](safety.md)");
  private static final Option ARM =
      Option.of("--arm", new OptionArgument.Choice("dynamic", "ideal"))
          .standing("dynamic")
          .documented(
              "dynamic",
              "`dynamic` (default): an arm with masses, friction and drives, see"
                  + " [simulated-arm.md](simulated-arm.md); `ideal`: one that is always exactly"
                  + " where it should be, weighs nothing, and pushes and carries what has a mass"
                  + " without being pushed back");
  static final Option NOISE =
      Option.of("--noise", new OptionArgument.Choice("measured", "none"))
          .documented(
              "measured",
              "`measured`: readings of the arm's sensors and its supply have the noise and the"
                  + " steps of recorded arms, see [simulated-arm.md](simulated-arm.md#noise);"
                  + " `none`: they are exact. Default `none`, for `serve` and the window"
                  + " `measured`");
  private static final Option ENCODER_NOISE =
      Option.of("--encoder-noise", new OptionArgument.Real("RAD", 0, MAX_NOISE_RAD, false, "rad"))
          .documented(
              "RAD",
              "standard deviation of each reading of a joint encoder, 0 to 0.01 rad; default as"
                  + " `--noise` says");

  static final Option START_RAMP =
      Option.of("--start-ramp", new OptionArgument.Choice("on", "off"))
          .standing("on")
          .documented(
              "on",
              "`on` (default): in the first 0.160 s of a program moves run slower, as on real arms,"
                  + " see [motion.md](motion.md#the-start-of-a-program); `off`: they do not");

  /** For the usage text. */
  static final List<Option> ALL =
      List.of(SCENE, DEVICE, SAFETY, ARM, NOISE, ENCODER_NOISE, START_RAMP);

  private SimulationOptions() {}

  /** {@code options} with what the command line says about the arm's surroundings. */
  static ControllerOptions in(ControllerOptions options, Arguments arguments)
      throws UsageException {
    ControllerOptions chosen =
        options
            .withArm(arm(arguments))
            .withMeasuredNoise(measuredNoise(arguments, false))
            .withStartRamp(startRamp(arguments));
    OptionalDouble encoderNoiseRad = arguments.number(ENCODER_NOISE);
    if (encoderNoiseRad.isPresent()) {
      chosen = chosen.withEncoderNoise(encoderNoiseRad.getAsDouble());
    }
    Optional<String> scene = arguments.value(SCENE);
    if (scene.isPresent()) {
      chosen = withScene(chosen, scene.get(), arguments);
    }
    chosen = chosen.withEquipment(equipped(chosen.equipment(), arguments));
    Optional<String> safety = arguments.value(SAFETY);
    if (safety.isPresent()) {
      chosen = chosen.withSafety(safety(safety.get(), options.arm(), arguments.files()));
    }
    return chosen;
  }

  /** {@code options} in a scene, with what in it answers the program. */
  static ControllerOptions withScene(ControllerOptions options, String name, Arguments arguments)
      throws UsageException {
    return options
        .withScene(scene(name, arguments.files()))
        .withEquipment(equipment(name, arguments.files()));
  }

  private static CellEquipment equipped(CellEquipment cell, Arguments arguments)
      throws UsageException {
    List<DeviceSetup> devices = new ArrayList<>();
    for (String kind : arguments.values(DEVICE)) {
      devices.add(
          DeviceSetup.of(kind)
              .orElseThrow(
                  () ->
                      new UsageException(
                          text(
                              "quotedMustBe",
                              DEVICE.name(),
                              kind,
                              ((OptionArgument.Choice) DEVICE.argument()).legal()))));
    }
    try {
      return cell.and(devices);
    } catch (IllegalArgumentException e) {
      throw new UsageException(DEVICE.name() + ": " + CommandLanguage.shown(e.getMessage()));
    }
  }

  /**
   * Whether sensors err as those of recorded arms.
   *
   * @param otherwise when the command line does not say
   */
  static boolean measuredNoise(Arguments arguments, boolean otherwise) throws UsageException {
    return arguments.word(NOISE).map(word -> word.equals("measured")).orElse(otherwise);
  }

  private static ArmChoice arm(Arguments arguments) throws UsageException {
    return arguments.word(ARM).orElseThrow().equals("ideal") ? ArmChoice.IDEAL : ArmChoice.DYNAMIC;
  }

  /** Whether programs have a start ramp. */
  static boolean startRamp(Arguments arguments) throws UsageException {
    return arguments.word(START_RAMP).orElseThrow().equals("on");
  }

  private static Scene scene(String name, SourceFiles files) throws UsageException {
    Path file = files.path("theScene", name);
    try (InputStream in = Files.newInputStream(file)) {
      return SceneReader.read(name, in, MeshFiles.in(file.toAbsolutePath().getParent()));
    } catch (JsonException e) {
      throw UsageException.fromEnglish(e);
    } catch (IOException e) {
      throw SourceFiles.unreadable(name, e);
    }
  }

  private static CellEquipment equipment(String name, SourceFiles files) throws UsageException {
    try (InputStream in = Files.newInputStream(files.path("theScene", name))) {
      return EquipmentReader.read(name, in);
    } catch (JsonException e) {
      throw UsageException.fromEnglish(e);
    } catch (IOException e) {
      throw SourceFiles.unreadable(name, e);
    }
  }

  /**
   * The file of the scene that the command line names; empty if it names none.
   *
   * @throws UsageException if it cannot be read or is no scene
   */
  static Optional<Path> sceneFile(Arguments arguments) throws UsageException {
    Optional<String> name = arguments.value(SCENE);
    if (name.isPresent()) {
      scene(name.get(), arguments.files());
      equipment(name.get(), arguments.files());
    }
    return name.map(each -> Path.of(each).toAbsolutePath());
  }

  /**
   * The kinds of devices that the command line names.
   *
   * @throws UsageException if the cell cannot have them besides those of the scene
   */
  static List<String> devices(Arguments arguments) throws UsageException {
    Optional<String> scene = arguments.value(SCENE);
    CellEquipment cell =
        scene.isPresent() ? equipment(scene.get(), arguments.files()) : CellEquipment.NONE;
    equipped(cell, arguments);
    return arguments.values(DEVICE);
  }

  private static SafetyConfiguration safety(String name, ArmDescription robot, SourceFiles files)
      throws UsageException {
    try (InputStream in = Files.newInputStream(files.path("theSafetyFile", name))) {
      return SafetyConfigurationReader.read(name, in, robot);
    } catch (JsonException e) {
      throw UsageException.fromEnglish(e);
    } catch (IOException e) {
      throw SourceFiles.unreadable(name, e);
    }
  }
}
