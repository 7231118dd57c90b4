package org.pendant.controller.rtde;

import static org.pendant.controller.rtde.RtdeInputTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.controller.box.Published;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.models.pose.Wrench;

/**
 * Input gathering: puts the values of one package together. A mask may stand before or after what
 * it selects, so both are kept until the end.
 */
final class InputGathering {
  private final List<SignalWrite> writes = new ArrayList<>();
  private final List<String> ignored = new ArrayList<>();
  private final Outputs standard = new Outputs(SignalBank.STANDARD_OUT);
  private final Outputs configurable = new Outputs(SignalBank.CONFIGURABLE_OUT);
  private final Outputs tool = new Outputs(SignalBank.TOOL_OUT);
  private final double[] analogRatios = new double[AnalogBank.SIZE];
  private int analogGiven;
  private int analogMask;
  private Optional<Integer> analogTypes = Optional.empty();
  private long speedMask;
  private OptionalDouble speedFraction = OptionalDouble.empty();
  private Optional<Wrench> externalWrench = Optional.empty();

  /** Digital outputs that are set together. */
  static final class Outputs {
    private final SignalBank bank;
    private boolean given;
    private int mask;
    private int levels;

    private Outputs(SignalBank bank) {
      this.bank = bank;
    }

    void setMask(int mask) {
      this.mask = mask;
    }

    void setLevels(int levels) {
      this.levels = levels;
      given = true;
    }

    private void addTo(List<SignalWrite> writes) {
      for (int i = 0; given && i < bank.size(); i++) {
        if ((mask >> i & 1) != 0) {
          writes.add(new SignalWrite.Digital(new Signal(bank, i), (levels >> i & 1) != 0));
        }
      }
    }
  }

  Outputs outputs(SignalBank bank) {
    return switch (bank) {
      case STANDARD_OUT -> standard;
      case CONFIGURABLE_OUT -> configurable;
      case TOOL_OUT -> tool;
      case STANDARD_IN, CONFIGURABLE_IN, TOOL_IN, FLAG ->
          throw new IllegalArgumentException(bank + " is no output");
    };
  }

  /** A register, which nothing selects. */
  void write(SignalWrite write) {
    writes.add(write);
  }

  void setAnalogMask(int mask) {
    analogMask = mask;
  }

  void setAnalogTypes(int types) {
    analogTypes = Optional.of(types);
  }

  void setAnalogRatio(int index, double ratio) {
    analogRatios[index] = ratio;
    analogGiven |= 1 << index;
  }

  void setSpeedMask(long mask) {
    speedMask = mask;
  }

  void setSpeedFraction(double fraction) {
    speedFraction = OptionalDouble.of(fraction);
  }

  void setExternalWrench(double[] values) {
    for (double value : values) {
      if (!Double.isFinite(value)) {
        ignored.add(text("notFinite", Published.EXTERNAL_FORCE_TORQUE, value));
        return;
      }
    }
    externalWrench =
        Optional.of(new Wrench(values[0], values[1], values[2], values[3], values[4], values[5]));
  }

  /** What the package asks for. */
  InputUpdate finish(InputRecipe recipe) {
    standard.addTo(writes);
    configurable.addTo(writes);
    tool.addTo(writes);
    for (int i = 0; i < AnalogBank.SIZE; i++) {
      if ((analogMask >> i & 1) != 0) {
        addAnalog(i);
      }
    }
    return new InputUpdate(recipe, writes, selectedSpeed(), externalWrench, ignored);
  }

  private void addAnalog(int index) {
    analogTypes.ifPresent(
        types ->
            writes.add(
                new SignalWrite.Domain(
                    AnalogBank.STANDARD_OUT, index, AnalogDomain.of(types >> index & 1))));
    if ((analogGiven >> index & 1) == 0) {
      return;
    }
    double ratio = analogRatios[index];
    if (ratio >= 0 && ratio <= 1) {
      writes.add(new SignalWrite.AnalogOutput(index, ratio));
    } else {
      ignored.add(text("analogOutput", index, ratio));
    }
  }

  private OptionalDouble selectedSpeed() {
    if (speedMask == 0 || speedFraction.isEmpty()) {
      return OptionalDouble.empty();
    }
    double fraction = speedFraction.getAsDouble();
    if (fraction >= 0 && fraction <= 1) {
      return speedFraction;
    }
    ignored.add(text("speedSlider", fraction));
    return OptionalDouble.empty();
  }
}
