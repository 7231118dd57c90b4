package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.nio.charset.StandardCharsets;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.Clock;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.VirtualClock;
import org.pendant.controller.WallClock;
import org.pendant.controller.encoder.Encoder;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.controller.io.SignalText;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.io.UnknownSignal;
import org.pendant.controller.io.WaveformText;
import org.pendant.controller.message.Operator;
import org.pendant.controller.message.PreparedAnswer;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.language.source.ByteText;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Calibration;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.externalcontrol.Drivers;

/**
 * Run options: what {@code pendant run} was asked for.
 *
 * @param controller how each controller is switched on
 * @param hosts where programs may connect to
 * @param drivers who can be asked for the script of External Control nodes
 * @param waveforms what happens at the inputs while a program runs
 * @param speedFactor how fast time goes against the wall clock; empty for as fast as possible
 * @param record the file to record to, by name
 * @param timeoutS robot time after which a program is stopped, s
 * @param wallTimeoutS time on the wall after which a program is stopped, s
 * @param toolDevice the serial device at the tool connector
 */
record RunOptions(
    ControllerOptions controller,
    AllowedHosts hosts,
    Drivers drivers,
    InputWaveforms waveforms,
    Optional<Double> speedFactor,
    Optional<String> record,
    OptionalDouble timeoutS,
    OptionalDouble wallTimeoutS,
    Optional<String> toolDevice) {

  /** A time after which something is stopped. */
  static final OptionArgument.Real SECONDS =
      new OptionArgument.Real("S", 0, Double.POSITIVE_INFINITY, true, "seconds");

  static final Option ROBOT =
      Option.of("--robot", new OptionArgument.Text("NAME|FILE", ArmLibrary.ids()))
          .reading()
          .documented(
              "ur5e",
              "which arm, by id or name (`ur8long`, `\"UR8 Long\"`), in capitals or not; default"
                  + " the one that a `.urp` was made on, else `ur5e`. [robots.md](robots.md) has"
                  + " them all. A name that ends in `.json` is a file with the numbers of your own"
                  + " arm");
  private static final Option SPEED =
      Option.of("--speed", new OptionArgument.Text("max|1|N", List.of("max", "1")))
          .standing("max")
          .documented(
              "max",
              "how fast time goes: `max` (default) as fast as possible, `1` like the wall clock,"
                  + " `N` N times as fast");
  private static final Option INPUT =
      Option.text("--input", "NAME=LEVEL")
          .repeated()
          .documented(
              "\"digital_in[0]=true\"",
              "what an input has from the start; may be repeated, see [below](#inputs)");
  private static final Option WAVEFORMS =
      Option.text("--waveforms", "FILE")
          .reading()
          .documented(
              "inputs.csv",
              "what happens at the inputs while a program runs: a table of times, signals and"
                  + " values, see [below](#waveforms)");
  private static final Option ENCODER =
      Option.text("--encoder", "N=RATE")
          .repeated()
          .documented(
              "0=RATE",
              "a belt turns encoder 0 or 1 from the start, RATE ticks a second (-1000000 to"
                  + " 1000000); may be repeated, see [conveyors.md](conveyors.md)");
  private static final Option ANSWER =
      Option.text("--answer", "TEXT=VALUE")
          .repeated()
          .documented(
              "\"text=value\"",
              "the answer to a question that the program asks, see below; may be repeated");
  static final Option RECORD =
      Option.output("--record", "FILE")
          .documented(
              "out.csv",
              "write what the arm did, a row each frame; a name that ends in `.rec` makes a"
                  + " [recording](recording.md) of everything instead; with one file only; [never"
                  + " onto what the run reads](#files-that-are-written)");
  private static final Option TIMEOUT =
      Option.of("--timeout", SECONDS).documented("S", "stop after S seconds of robot time");
  private static final Option SEED =
      Option.text("--seed", "N")
          .standing("0")
          .documented("N", "start of `random()` and of the noise of sensors; default 0");

  private static final List<String> SAFETY_INPUTS =
      Arrays.stream(SafetyInput.values()).map(SafetyInput::word).toList();

  /** For the usage text. */
  static final List<Option> ALL =
      Stream.concat(
              Stream.of(
                  ROBOT,
                  CalibrationOption.OPTION,
                  InstallationOption.OPTION,
                  SPEED,
                  INPUT,
                  WAVEFORMS,
                  ENCODER,
                  ANSWER,
                  RECORD,
                  OutputFile.FORCE,
                  RecordColumns.OPTION,
                  LineReport.OPTION,
                  TIMEOUT,
                  WallLimit.OPTION,
                  SEED,
                  MemoryOption.OPTION,
                  HostsOption.OPTION,
                  ControlOption.OPTION,
                  ToolSerialOption.OPTION),
              SimulationOptions.ALL.stream())
          .toList();

  /** What says how a program runs, whatever is made of the run. */
  static final List<Option> OF_PROGRAM =
      without(
          ALL,
          SPEED,
          RECORD,
          OutputFile.FORCE,
          RecordColumns.OPTION,
          LineReport.OPTION,
          ToolSerialOption.OPTION);

  /** What says what a controller is and what surrounds it, whatever it is to do. */
  static final List<Option> OF_CONTROLLER =
      without(OF_PROGRAM, ANSWER, WAVEFORMS, TIMEOUT, WallLimit.OPTION);

  /** What says what the controllers of tests are and what surrounds them. */
  static final List<Option> OF_TESTS =
      without(OF_CONTROLLER, SEED, HostsOption.OPTION, ControlOption.OPTION);

  /** What says how a program runs that an editor debugs: nothing is written, no time is up. */
  static final List<Option> OF_DEBUGGING =
      without(
          ALL,
          RECORD,
          OutputFile.FORCE,
          RecordColumns.OPTION,
          LineReport.OPTION,
          TIMEOUT,
          WallLimit.OPTION,
          ToolSerialOption.OPTION);

  /** What says what a robot is that other programs drive. */
  static final List<Option> OF_ROBOT = without(OF_PROGRAM, TIMEOUT, WallLimit.OPTION);

  /** What says how a program runs that is looked at for collisions: it reaches nothing outside. */
  static final List<Option> OF_CHECK =
      without(OF_PROGRAM, SimulationOptions.SCENE, HostsOption.OPTION, ControlOption.OPTION);

  private static List<Option> without(List<Option> options, Option... others) {
    return options.stream().filter(each -> !List.of(others).contains(each)).toList();
  }

  static RunOptions of(Arguments arguments) throws UsageException {
    return of(arguments, Optional.empty(), Optional.empty());
  }

  /**
   * With the installation and arm of a program, unless the command line names others.
   *
   * @param armOfProgram id of the arm that it was made on
   */
  static RunOptions of(
      Arguments arguments, Optional<Installation> ofProgram, Optional<String> armOfProgram)
      throws UsageException {
    return of(arguments, ofProgram, armOfProgram, Optional.empty());
  }

  /**
   * As the other one.
   *
   * @param recorded the arm of a recording, which counts unless the command line names another
   */
  static RunOptions of(
      Arguments arguments,
      Optional<Installation> ofProgram,
      Optional<String> armOfProgram,
      Optional<ArmDescription> recorded)
      throws UsageException {
    ControllerOptions controller =
        controller(arguments, ofProgram, armOfProgram, recorded)
            .withOperator(Operator.headless(answers(arguments)));
    Optional<Double> speedFactor = speedFactor(arguments);
    if (speedFactor.isPresent()) {
      // No user expects the same result twice from a run on the wall clock, but the right date.
      controller = controller.withSystemTime(InstantSource.system());
    }
    return new RunOptions(
        controller,
        HostsOption.of(arguments),
        ControlOption.of(arguments),
        waveforms(arguments),
        speedFactor,
        arguments.value(RECORD),
        arguments.number(TIMEOUT),
        arguments.number(WallLimit.OPTION),
        ToolSerialOption.of(arguments));
  }

  /** What {@link #OF_CONTROLLER} say. */
  static ControllerOptions controller(Arguments arguments) throws UsageException {
    return controller(arguments, Optional.empty(), Optional.empty(), Optional.empty());
  }

  /**
   * As {@link #controller(Arguments)}, with what {@link #of(Arguments, Optional, Optional)} has.
   */
  static ControllerOptions controller(
      Arguments arguments,
      Optional<Installation> ofProgram,
      Optional<String> armOfProgram,
      Optional<ArmDescription> recorded)
      throws UsageException {
    Optional<Installation> installation = InstallationOption.of(arguments).or(() -> ofProgram);
    boolean asRecorded = recorded.isPresent() && !arguments.has(ROBOT);
    ControllerOptions model =
        asRecorded
            ? ControllerOptions.headless().withRobot(recorded.get())
            : robot(arguments, installation, armOfProgram);
    Calibration named = CalibrationOption.of(arguments, installation, model.arm());
    ControllerOptions controller =
        model
            .withCalibration(
                asRecorded && named.equals(Calibration.NONE) ? recorded.get().calibration() : named)
            .withSeed(seed(arguments))
            .withInputs(safetyInputs(arguments))
            .withSignals(signals(arguments))
            .withEncoders(encoders(arguments))
            .withMemory(MemoryOption.of(arguments));
    ControllerOptions placed = SimulationOptions.in(controller, arguments);
    return installation.isPresent() ? InstallationOption.in(placed, installation.get()) : placed;
  }

  /** The same without an end in robot time. */
  RunOptions withoutTimeout() {
    return new RunOptions(
        controller,
        hosts,
        drivers,
        waveforms,
        speedFactor,
        record,
        OptionalDouble.empty(),
        wallTimeoutS,
        toolDevice);
  }

  /** A clock for one run. */
  Clock clock() {
    return speedFactor.isPresent() ? new WallClock(speedFactor.get()) : new VirtualClock();
  }

  /** With the arm of the command line, or else the installation's, or else the program's. */
  private static ControllerOptions robot(
      Arguments arguments, Optional<Installation> installation, Optional<String> armOfProgram)
      throws UsageException {
    ControllerOptions options = ControllerOptions.headless();
    Optional<String> name = arguments.value(ROBOT);
    if (name.isPresent()) {
      return RobotName.isFile(name.get())
          ? options.withRobot(RobotName.read(name.get(), arguments.files()))
          : options.withRobot(RobotName.idOf(ROBOT::name, name.get()));
    }
    Optional<String> installed =
        installation.map(Installation::robot).filter(robot -> !robot.isEmpty());
    return options.withRobot(
        installed.isPresent()
            ? RobotName.idOf(() -> text("robotOfInstallation"), installed.get())
            : armOfProgram.orElse(ControllerOptions.DEFAULT_ROBOT));
  }

  private static long seed(Arguments arguments) throws UsageException {
    String text = arguments.text(SEED);
    try {
      return Long.parseLong(text);
    } catch (NumberFormatException e) {
      throw new UsageException(text("seedMustBe", text));
    }
  }

  private static Optional<Double> speedFactor(Arguments arguments) throws UsageException {
    String text = arguments.text(SPEED);
    if (text.equals("max")) {
      return Optional.empty();
    }
    OptionalDouble factor = Arguments.parsed(text);
    if (!(factor.orElse(0) > 0 && factor.orElse(0) <= 1000)) {
      throw new UsageException(text("speedMustBe", text));
    }
    return Optional.of(factor.getAsDouble());
  }

  private static Map<String, Boolean> safetyInputs(Arguments arguments) throws UsageException {
    Map<String, Boolean> inputs = new HashMap<>();
    for (String text : arguments.values(INPUT)) {
      int equals = separator(INPUT, text);
      String name = text.substring(0, equals);
      if (SAFETY_INPUTS.contains(name)) {
        try {
          inputs.put(name, SignalText.level(text.substring(equals + 1)));
        } catch (IllegalArgumentException e) {
          throw new UsageException(
              "--input " + text + ": " + CommandLanguage.shown(e.getMessage()));
        }
      }
    }
    return inputs;
  }

  private static List<SignalWrite> signals(Arguments arguments) throws UsageException {
    List<SignalWrite> writes = new ArrayList<>();
    for (String text : arguments.values(INPUT)) {
      int equals = separator(INPUT, text);
      String name = text.substring(0, equals);
      if (!SAFETY_INPUTS.contains(name)) {
        try {
          writes.addAll(SignalText.input(name, text.substring(equals + 1)));
        } catch (UnknownSignal e) {
          throw new UsageException(
              text("inputNameOr", text, e.getMessage(), String.join(", ", SAFETY_INPUTS)));
        } catch (IllegalArgumentException e) {
          throw new UsageException(
              "--input " + text + ": " + CommandLanguage.shown(e.getMessage()));
        }
      }
    }
    return writes;
  }

  private static InputWaveforms waveforms(Arguments arguments) throws UsageException {
    Optional<String> name = arguments.value(WAVEFORMS);
    if (name.isEmpty()) {
      return InputWaveforms.NONE;
    }
    byte[] table = arguments.files().bytes("theWaveforms", name.get());
    try {
      return WaveformText.parse(name.get(), new String(table, StandardCharsets.UTF_8));
    } catch (IllegalArgumentException e) {
      throw UsageException.fromEnglish(e);
    }
  }

  private static Map<Integer, Double> encoders(Arguments arguments) throws UsageException {
    Map<Integer, Double> belts = new HashMap<>();
    for (String text : arguments.values(ENCODER)) {
      int equals = separator(ENCODER, text);
      String index = text.substring(0, equals);
      if (!index.equals("0") && !index.equals("1")) {
        throw new UsageException(text("encoderMustBe", text, index));
      }
      String rate = text.substring(equals + 1);
      double ticksPerS = Arguments.parsed(rate).orElse(Double.NaN);
      if (!(Math.abs(ticksPerS) <= Encoder.MAX_TICKS_PER_S)) {
        throw new UsageException(text("encoderRateMustBe", index, rate));
      }
      belts.put(Integer.parseInt(index), ticksPerS);
    }
    return belts;
  }

  private static List<PreparedAnswer> answers(Arguments arguments) throws UsageException {
    List<PreparedAnswer> answers = new ArrayList<>();
    for (String text : arguments.values(ANSWER)) {
      separator(ANSWER, text);
      answers.add(new PreparedAnswer(ByteText.asBytes(text)));
    }
    return answers;
  }

  private static int separator(Option option, String text) throws UsageException {
    int equals = text.indexOf('=');
    if (equals < 0) {
      throw new UsageException(text("mustBe", option.name(), text, option.value()));
    }
    return equals;
  }
}
