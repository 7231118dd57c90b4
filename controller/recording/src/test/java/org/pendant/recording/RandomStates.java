package org.pendant.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.pendant.controller.box.BaseLight;
import org.pendant.controller.box.Mounting;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.eip.AssemblyData;
import org.pendant.controller.eip.AssemblyImage;
import org.pendant.controller.eip.AssemblyPair;
import org.pendant.controller.encoder.Encoders;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.freedrive.FreedriveHolder;
import org.pendant.controller.freedrive.FreedriveMode;
import org.pendant.controller.freedrive.FreedriveState;
import org.pendant.controller.freedrive.SingularityDistance;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.AnalogLevels;
import org.pendant.controller.io.AnalogSignal;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.InputActions;
import org.pendant.controller.io.PortLevels;
import org.pendant.controller.io.RegisterLevels;
import org.pendant.controller.io.SignalState;
import org.pendant.controller.io.ToolConnector;
import org.pendant.controller.io.ToolOutputMode;
import org.pendant.controller.io.ToolPinMode;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.LogLines;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.modbus.ModbusSignalState;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyChecksum;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.safety.StopCategory;
import org.pendant.controller.state.ArmGeometry;
import org.pendant.controller.state.ArmReadings;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControlMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.LinkDistance;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.controller.state.RuntimeState;
import org.pendant.controller.state.SafetyStatus;
import org.pendant.controller.state.StopPlace;
import org.pendant.controller.state.SupplyVoltages;
import org.pendant.controller.wire.SignalGroupState;
import org.pendant.controller.world.LinkDistances;
import org.pendant.controller.world.MovedObject;
import org.pendant.language.signature.Type;
import org.pendant.language.source.SourceRange;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;
import org.pendant.motion.MotionFailure;
import org.pendant.script.debug.DebugState;
import org.pendant.script.debug.PauseReason;
import org.pendant.script.function.ScriptPlace;
import org.pendant.script.value.HandleValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ObjectList;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;
import org.pendant.script.variables.TracedVariables;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.variables.VariableSamples;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramEvent;
import org.pendant.script.vm.ProgramLabel;
import org.pendant.script.vm.ProgramState;
import org.pendant.script.vm.ScriptFailure;
import org.pendant.script.vm.ThreadSnapshot;

/** Snapshots in which anything can stand, each with some parts of the one before. */
final class RandomStates {
  private static final ArmDescription ARM = ArmLibrary.load("ur10e");
  private static final ForwardKinematics KINEMATICS = new ForwardKinematics(ARM);

  private final Random random;
  private Optional<ControllerState> last = Optional.empty();
  private long frame;
  private long newest;

  RandomStates(long seed) {
    random = new Random(seed);
  }

  /** The next frame, or one some frames later, or the same again as a debugger makes it. */
  ControllerState next() {
    frame += random.nextInt(10) == 0 ? random.nextInt(1000) : random.nextInt(8) == 0 ? 0 : 1;
    Optional<ArmState> armBefore = last.map(ControllerState::arm);
    ArmState arm =
        new ArmState(
            some(armBefore.map(ArmState::targetPositionRad), this::joints),
            some(armBefore.map(ArmState::targetSpeedRadPerS), this::joints),
            some(armBefore.map(ArmState::targetAccelerationRadPerS2), this::joints),
            some(armBefore.map(ArmState::actualPositionRad), this::joints),
            some(armBefore.map(ArmState::actualSpeedRadPerS), this::joints),
            some(armBefore.map(ArmState::tool), () -> new ToolCentre(pose(), text())),
            ARM,
            KINEMATICS,
            some(armBefore.map(ArmState::controlMode), () -> of(ControlMode.class)),
            some(armBefore.map(ArmState::moving), random::nextBoolean),
            some(armBefore.map(ArmState::steady), random::nextBoolean),
            some(armBefore.map(ArmState::speedFraction), this::number),
            some(armBefore.map(ArmState::speedScaling), this::number),
            maybe(() -> new MotionFailure(text(), text())));
    ArmReadings readings = some(last.map(ControllerState::readings), this::readings);
    LinkDistances distances = new LinkDistances(number(), number());
    LinkDistance links = each -> distances;
    boolean news = random.nextInt(4) == 0;
    List<LogEntry> entries = news ? list(this::entry) : List.of();
    ControllerState state =
        new ControllerState(
            frame,
            frame / 500.0,
            some(last.map(ControllerState::executionTimeS), this::number),
            0,
            false,
            arm,
            readings,
            new ArmGeometry(arm, readings, links),
            some(last.map(ControllerState::safety), this::safety),
            some(last.map(ControllerState::program), this::program),
            some(last.map(ControllerState::debug), this::debug),
            some(last.map(ControllerState::io), this::digital),
            some(last.map(ControllerState::signals), this::signals),
            some(last.map(ControllerState::modbus), () -> list(this::modbus)),
            some(last.map(ControllerState::devices), () -> list(this::device)),
            last.isPresent() && frame % SnapshotPart.MOVED_FRAMES != 0
                ? last.get().moved()
                : list(this::body),
            some(last.map(ControllerState::assemblies), this::assemblies),
            some(
                last.map(ControllerState::encoders),
                () -> new Encoders.Counts(random.nextInt(), random.nextInt())),
            some(last.map(ControllerState::freedrive), this::freedrive),
            some(last.map(ControllerState::variables), this::variables),
            some(last.map(ControllerState::traced), this::traced),
            some(last.map(ControllerState::openPopups), () -> list(this::popup)),
            some(last.map(ControllerState::openQuestions), () -> list(this::question)),
            entries.isEmpty() ? LogLines.NONE : new LogLines.Listed(entries),
            news ? list(this::popup) : List.of(),
            news ? list(this::question) : List.of(),
            news ? list(this::event) : List.of(),
            newest);
    last = Optional.of(state);
    return state;
  }

  private <T> T some(Optional<T> before, Supplier<T> made) {
    return before.isPresent() && random.nextInt(3) > 0 ? before.get() : made.get();
  }

  private <T> Optional<T> maybe(Supplier<T> made) {
    return random.nextBoolean() ? Optional.of(made.get()) : Optional.empty();
  }

  private <T> List<T> list(Supplier<T> made) {
    return IntStream.range(0, random.nextInt(4)).mapToObj(i -> made.get()).toList();
  }

  private <E extends Enum<E>> E of(Class<E> type) {
    E[] all = type.getEnumConstants();
    return all[random.nextInt(all.length)];
  }

  private double number() {
    return switch (random.nextInt(8)) {
      case 0 -> 0;
      case 1 -> -0.0;
      case 2 -> Double.NaN;
      case 3 -> Double.NEGATIVE_INFINITY;
      case 4 -> Double.MIN_VALUE;
      default -> random.nextGaussian();
    };
  }

  private Joints joints() {
    return new Joints(number(), number(), number(), number(), number(), number());
  }

  private Pose pose() {
    return new Pose(number(), number(), number(), number(), number(), number());
  }

  private Wrench wrench() {
    return new Wrench(number(), number(), number(), number(), number(), number());
  }

  private String text() {
    StringBuilder text = new StringBuilder();
    int length = random.nextInt(10) == 0 ? random.nextInt(2000) : random.nextInt(12);
    for (int i = 0; i < length; i++) {
      text.append((char) (random.nextInt(20) == 0 ? 0x20AC : random.nextInt(256)));
    }
    return text.toString();
  }

  private ArmReadings readings() {
    return new ArmReadings(
        joints(),
        joints(),
        joints(),
        joints(),
        joints(),
        joints(),
        joints(),
        number(),
        number(),
        number(),
        new ArmReadings.Acceleration(number(), number(), number()),
        wrench(),
        wrench(),
        Payload.of(random.nextDouble(), random.nextDouble(), random.nextDouble(), -0.0),
        new Mounting(number(), number(), number(), number(), number(), number()),
        new SupplyVoltages(number(), number(), joints()),
        number(),
        number(),
        number(),
        number(),
        number(),
        number());
  }

  private SafetyStatus safety() {
    return new SafetyStatus(
        of(RobotMode.class),
        of(SafetyMode.class),
        maybe(
            () ->
                new SafetyStop(
                    of(SafetyMode.class),
                    of(StopCategory.class),
                    random.nextInt(300),
                    random.nextInt(300),
                    random.nextBoolean() ? OptionalInt.of(random.nextInt(6)) : OptionalInt.empty(),
                    number(),
                    number(),
                    number(),
                    text(),
                    text())),
        maybe(() -> new StopPlace(random.nextInt(), pose(), joints())),
        random.nextBoolean(),
        switch (random.nextInt(3)) {
          case 0 -> BaseLight.STANDARD;
          case 1 -> BaseLight.OFF;
          default -> new BaseLight.Solid(random.nextInt(256), random.nextInt(256), 0);
        },
        random.nextBoolean(),
        new SafetyChecksum(random.nextInt()));
  }

  private SourceRange range() {
    int start = random.nextInt(1000);
    return new SourceRange(start, start + random.nextInt(100));
  }

  private ScriptFailure failure() {
    return new ScriptFailure(
        text(),
        text(),
        range(),
        random.nextInt(),
        random.nextInt(),
        list(() -> new ScriptFailure.StackEntry(text(), random.nextInt())));
  }

  private Ending ending() {
    return switch (random.nextInt(4)) {
      case 0 -> new Ending.Finished();
      case 1 -> new Ending.Halted();
      case 2 -> new Ending.Stopped();
      default -> new Ending.Failed(failure());
    };
  }

  private ProgramStatus program() {
    return new ProgramStatus(
        of(ProgramState.class),
        of(RuntimeState.class),
        text(),
        random.nextInt(),
        maybe(this::ending));
  }

  private DebugState debug() {
    PauseReason reason =
        switch (random.nextInt(5)) {
          case 0 -> new PauseReason.AtBreakpoint(random.nextInt(), random.nextLong());
          case 1 -> new PauseReason.ConditionFailed(random.nextInt(), text());
          case 2 -> new PauseReason.Stepped();
          case 3 -> new PauseReason.PauseRequested();
          default -> new PauseReason.Failed(failure());
        };
    return new DebugState(
        maybe(() -> new DebugState.Stop(random.nextLong(), reason, random.nextInt(), 3)),
        list(
            () ->
                new ThreadSnapshot(
                    random.nextInt(),
                    text(),
                    text(),
                    List.of(new ThreadSnapshot.Level(text(), text(), random.nextInt(), range())))));
  }

  private DigitalLevels digital() {
    return new DigitalLevels(
        random.nextInt(256),
        random.nextInt(256),
        random.nextInt(256),
        random.nextInt(256),
        random.nextInt(4),
        random.nextInt(4),
        random.nextInt());
  }

  private AnalogSignal analog() {
    return new AnalogSignal(number(), of(AnalogDomain.class));
  }

  private RegisterLevels registers() {
    return RegisterLevels.of(
        random.nextLong(),
        random.nextLong(),
        random.ints(48).toArray(),
        random.doubles(48).toArray());
  }

  private SignalState signals() {
    short[] ports = new short[128];
    ports[random.nextInt(128)] = (short) random.nextInt();
    return new SignalState(
        new AnalogLevels(analog(), analog(), analog(), analog(), analog(), analog()),
        new ToolConnector(
            12 * random.nextInt(3),
            of(ToolOutputMode.class),
            of(ToolPinMode.class),
            of(ToolPinMode.class),
            new ToolCommunication(
                random.nextBoolean(),
                ToolCommunication.BAUD_RATES.get(random.nextInt(8)),
                of(ToolCommunication.Parity.class),
                1 + random.nextInt(2),
                1 + 39 * random.nextFloat(),
                40 * random.nextFloat())),
        registers(),
        registers(),
        PortLevels.of(random.nextLong(), random.nextLong(), ports),
        new InputActions(
            random.nextInt(256), random.nextInt(), 1, random.nextLong(), random.nextLong()));
  }

  private ModbusSignalState modbus() {
    return new ModbusSignalState(
        text(),
        new ModbusExchange(
            new ModbusAddress(text(), random.nextInt(65536)),
            random.nextInt(256),
            of(ModbusKind.class),
            random.nextInt(65536),
            random.nextInt(123),
            random.nextInt(65536),
            random.nextInt(123),
            random.nextBoolean()),
        random.nextInt(500),
        list(() -> random.nextInt(65536)),
        random.nextBoolean(),
        random.nextInt(),
        random.nextInt());
  }

  private AssemblyImage assemblies() {
    byte[] bytes = new byte[1 + random.nextInt(20)];
    random.nextBytes(bytes);
    return new AssemblyImage(
        list(() -> new AssemblyPair(200 + random.nextInt(50), 10, 300 + random.nextInt(50), 20)),
        Map.of(200, AssemblyData.of(bytes), 201, AssemblyData.zero(3)),
        Map.of(random.nextInt(), AssemblyData.of(bytes)));
  }

  private FreedriveState freedrive() {
    FreedriveFrame axes =
        switch (random.nextInt(3)) {
          case 0 -> FreedriveFrame.BASE;
          case 1 -> FreedriveFrame.TOOL;
          default -> new FreedriveFrame.Feature(pose());
        };
    return new FreedriveState(
        maybe(
            () ->
                new FreedriveMode(
                    of(FreedriveHolder.class),
                    FreeAxes.ALL.with(random.nextInt(6), random.nextBoolean()),
                    axes,
                    random.nextBoolean())),
        of(SingularityDistance.class));
  }

  private Value value(int depth) {
    return switch (random.nextInt(depth > 3 ? 6 : 12)) {
      case 0 -> NoneValue.NONE;
      case 1 -> Value.of(random.nextBoolean());
      case 2 -> Value.of(random.nextInt());
      case 3 -> Value.of(number());
      case 4 -> Value.of(text());
      case 5 -> new PoseValue(pose());
      case 6 -> NumberList.of(number(), number(), number());
      case 7 -> NumberList.ofBools(true, false);
      case 8 ->
          ObjectList.owning(
              new Value[] {Value.of(text()), Value.of(text())},
              random.nextInt(3),
              Value.of(text()));
      case 9 -> MatrixValue.owning(2, 3, random.doubles(6).toArray(), random.nextBoolean());
      case 10 -> StructValue.owning(List.of("a", "b"), value(depth + 1), value(depth + 1));
      default -> new HandleValue(of(Type.class), random.nextInt(), text());
    };
  }

  private VariableSample sample() {
    Optional<Value> value = maybe(() -> value(0));
    boolean list = value.map(each -> each.kind() == ValueKind.LIST).orElse(false);
    return VariableSample.of(text(), text(), value, list ? 100 : 0);
  }

  private VariableSamples variables() {
    List<VariableSample> globals = new ArrayList<>();
    List<VariableSample> before = last.map(state -> state.variables().globals()).orElse(List.of());
    for (int i = 0; i < random.nextInt(6); i++) {
      globals.add(i < before.size() && random.nextBoolean() ? before.get(i) : sample());
    }
    return new VariableSamples(
        random.nextLong(), globals, text(), list(this::sample), random.nextInt(1000));
  }

  private TracedVariables traced() {
    Optional<TracedVariables> before = last.map(ControllerState::traced);
    if (before.isPresent() && random.nextInt(4) > 0) {
      return before.get().withValues(random.doubles(before.get().names().size()).toArray());
    }
    List<String> names = list(this::text).stream().distinct().toList();
    return TracedVariables.of(names, random.doubles(names.size()).toArray());
  }

  private LogEntry entry() {
    newest++;
    return new LogEntry(
        newest,
        number(),
        of(LogEntry.Level.class),
        of(LogEntry.Origin.class),
        text(),
        text(),
        maybe(() -> new ScriptPlace(text(), random.nextInt(), text(), random.nextInt())));
  }

  private DeviceState device() {
    return new DeviceState(
        text(),
        text(),
        number(),
        number(),
        number(),
        random.nextBoolean(),
        number(),
        number(),
        random.nextInt(65536),
        (int) frame,
        frame % 2 == 0
            ? List.of()
            : List.of(
                new SignalGroupState("coil", 0, true, true, List.of((int) (frame & 1), 1)),
                new SignalGroupState("register", 7, false, false, List.of((int) frame, -1))));
  }

  private MovedObject body() {
    return new MovedObject(
        text(),
        new Pose(number(), number(), number(), number(), number(), number()),
        random.nextBoolean());
  }

  private Popup popup() {
    return new Popup(
        random.nextLong(),
        number(),
        text(),
        text(),
        of(Popup.Severity.class),
        random.nextBoolean());
  }

  private Question question() {
    return new Question(random.nextLong(), number(), of(Question.Kind.class), text());
  }

  private ProgramEvent event() {
    return switch (random.nextInt(3)) {
      case 0 ->
          new ProgramEvent.Started(
              text(), list(() -> new ProgramLabel(random.nextInt(), random.nextInt(), text())));
      case 1 -> new ProgramEvent.Ended(text(), ending());
      default -> new ProgramEvent.SecondaryFailed(text(), failure());
    };
  }
}
