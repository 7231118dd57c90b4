package org.pendant.controller.installation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Supplier;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.io.ToolCommunication;
import org.pendant.controller.io.ToolOutputMode;
import org.pendant.controller.io.ToolPinMode;
import org.pendant.controller.io.WatchdogAction;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyLimits;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.controller.safety.ToolDirection;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** Installations that nobody would make, but that can be written. */
public final class RandomInstallations {
  private static final String CHARACTERS =
      "aZ_09 \"\\\n\t\r#=[],.\u00e4\u20ac\u0001\u2028\u007f\uD83D\uDE00";

  private final Random random;

  /** The same ones for the same seed. */
  public RandomInstallations(long seed) {
    random = new Random(seed);
  }

  /** The next one. */
  public Installation next() {
    return new Installation(
        random.nextBoolean() ? "" : "ur10e",
        several(() -> new NamedTool(text(), pose())),
        text(),
        several(() -> new NamedPayload(text(), number(), vector(), inertia())),
        text(),
        new BaseMounting(number(), number()),
        several(
            () -> new SignalUse(text(), text(), any(InputAction.class), any(RunStateAction.class))),
        wiring(),
        several(this::feature),
        Joints.of(numbers(6)),
        several(() -> new InstallationVariable(text(), text(), random.nextBoolean())),
        new StartUp(text(), text(), random.nextBoolean(), text(), random.nextBoolean()),
        random.nextBoolean() ? Optional.empty() : Optional.of(safety()),
        several(this::conveyor),
        several(
            () ->
                new ModbusSetup(
                    text(),
                    text(),
                    random.nextInt(256),
                    any(ModbusKind.class),
                    random.nextInt(65536),
                    random.nextInt(500))),
        random.nextBoolean() ? Optional.empty() : Optional.of(any(WatchdogAction.class)),
        number(),
        new ControlHost(text(), random.nextInt(70_000)));
  }

  private <T> List<T> several(Supplier<T> one) {
    List<T> all = new ArrayList<>();
    for (int count = random.nextInt(4); count > 0; count--) {
      all.add(one.get());
    }
    return all;
  }

  private <E extends Enum<E>> E any(Class<E> type) {
    return type.getEnumConstants()[random.nextInt(type.getEnumConstants().length)];
  }

  private String text() {
    StringBuilder text = new StringBuilder();
    for (int length = random.nextInt(6); length > 0; length--) {
      text.append(CHARACTERS.charAt(random.nextInt(CHARACTERS.length())));
    }
    return text.toString();
  }

  private double number() {
    return switch (random.nextInt(5)) {
      case 0 -> 0;
      case 1 -> -0.0;
      case 2 -> random.nextInt(1000);
      case 3 -> random.nextGaussian() * Math.pow(10, random.nextInt(600) - 300);
      default -> random.nextGaussian();
    };
  }

  private double[] numbers(int count) {
    double[] numbers = new double[count];
    for (int i = 0; i < count; i++) {
      numbers[i] = number();
    }
    return numbers;
  }

  private Pose pose() {
    return Pose.of(numbers(6));
  }

  private Vector3 vector() {
    return new Vector3(number(), number(), number());
  }

  private Inertia inertia() {
    return Inertia.of(numbers(6));
  }

  private Wiring wiring() {
    return new Wiring(
        List.of(any(AnalogDomain.class), any(AnalogDomain.class)),
        List.of(any(AnalogDomain.class), any(AnalogDomain.class)),
        List.of(any(AnalogDomain.class), any(AnalogDomain.class)),
        12 * random.nextInt(3),
        any(ToolOutputMode.class),
        List.of(any(ToolPinMode.class), any(ToolPinMode.class)),
        new ToolCommunication(
            random.nextBoolean(),
            ToolCommunication.BAUD_RATES.get(random.nextInt(8)),
            any(ToolCommunication.Parity.class),
            1 + random.nextInt(2),
            1 + 39 * random.nextFloat(),
            40 * random.nextFloat()));
  }

  private Feature feature() {
    FeatureKind kind = any(FeatureKind.class);
    List<Pose> points = new ArrayList<>();
    for (int count = random.nextInt(kind.points() + 1); count > 0; count--) {
      points.add(pose());
    }
    return new Feature(text(), kind, points, random.nextBoolean(), random.nextBoolean());
  }

  private ConveyorSetup conveyor() {
    return new ConveyorSetup(
        random.nextInt(3),
        random.nextInt(2),
        text(),
        random.nextBoolean(),
        number(),
        random.nextBoolean(),
        random.nextInt(5),
        several(() -> random.nextInt(16)));
  }

  private SafetyConfiguration safety() {
    SafetyConfiguration standard = SafetyConfiguration.standard(ArmLibrary.load("ur5e"));
    List<SafetyPlane> planes = new ArrayList<>();
    for (int i = random.nextInt(4); i > 0; i--) {
      planes.add(
          new SafetyPlane(
              i + text(),
              random.nextGaussian(),
              random.nextGaussian(),
              random.nextGaussian(),
              axis(),
              any(Applies.class),
              random.nextBoolean()));
    }
    SafetyConfiguration limited =
        new SafetyConfiguration(
            limits(standard.normal(), 1),
            limits(standard.reduced(), 0.5 + random.nextDouble() / 2),
            planes,
            Optional.empty());
    return random.nextBoolean()
        ? limited
        : limited.withToolDirection(
            new ToolDirection(axis(), axis(), 0.1 + random.nextDouble(), Applies.REDUCED));
  }

  private SafetyLimits limits(SafetyLimits most, double share) {
    double endless = random.nextBoolean() && share == 1 ? Double.POSITIVE_INFINITY : 7;
    return new SafetyLimits(
        share * most.powerW(),
        share * most.momentumKgMPerS(),
        share * most.stoppingTimeS(),
        share * most.stoppingDistanceM(),
        share * most.toolSpeedMPerS(),
        share * most.toolForceN(),
        share * most.elbowSpeedMPerS(),
        share * most.elbowForceN(),
        most.jointSpeedRadPerS(),
        new Joints(-endless, -7, -7, -7, -7, -7),
        new Joints(7, 7, 7, 7, 7, endless));
  }

  private Axis axis() {
    return new Axis(random.nextGaussian(), random.nextGaussian(), 1 + random.nextDouble());
  }
}
