package org.pendant.controller.quantity;

import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

/**
 * A getter of the numbers of a quantity. Reading allocates nothing, except for what a snapshot
 * works out when it is asked first.
 */
public sealed interface Getter {
  /** Writes all numbers of a snapshot to {@code out}, from {@code out[at]} on. */
  void read(ControllerState state, double[] out, int at);

  /** Reads one of the numbers, as directly as it can be had; looked up beforehand. */
  ToDoubleFunction<ControllerState> element(int index);

  /** A number for each of some things. */
  @FunctionalInterface
  interface OfIndex {
    /** The number of thing {@code index}. */
    double value(ControllerState state, int index);
  }

  /** Numbers that are read one by one. */
  record OfScalars(List<ToDoubleFunction<ControllerState>> values) implements Getter {
    /** Copies the list. */
    public OfScalars {
      values = List.copyOf(values);
    }

    @Override
    public void read(ControllerState state, double[] out, int at) {
      for (int i = 0; i < values.size(); i++) {
        out[at + i] = values.get(i).applyAsDouble(state);
      }
    }

    @Override
    public ToDoubleFunction<ControllerState> element(int index) {
      return values.get(index);
    }
  }

  /** A number for each of {@code count} things. */
  record OfEach(int count, OfIndex value) implements Getter {
    @Override
    public void read(ControllerState state, double[] out, int at) {
      for (int i = 0; i < count; i++) {
        out[at + i] = value.value(state, i);
      }
    }

    @Override
    public ToDoubleFunction<ControllerState> element(int index) {
      return state -> value.value(state, index);
    }
  }

  /** A number for each joint. */
  record OfJoints(Function<ControllerState, Joints> value) implements Getter {
    @Override
    public void read(ControllerState state, double[] out, int at) {
      Joints joints = value.apply(state);
      out[at] = joints.q0();
      out[at + 1] = joints.q1();
      out[at + 2] = joints.q2();
      out[at + 3] = joints.q3();
      out[at + 4] = joints.q4();
      out[at + 5] = joints.q5();
    }

    @Override
    public ToDoubleFunction<ControllerState> element(int index) {
      return state -> value.apply(state).get(index);
    }
  }

  /** A pose, or what has the same six components. */
  record OfPose(Function<ControllerState, Pose> value) implements Getter {
    @Override
    public void read(ControllerState state, double[] out, int at) {
      Pose pose = value.apply(state);
      out[at] = pose.x();
      out[at + 1] = pose.y();
      out[at + 2] = pose.z();
      out[at + 3] = pose.rx();
      out[at + 4] = pose.ry();
      out[at + 5] = pose.rz();
    }

    @Override
    public ToDoubleFunction<ControllerState> element(int index) {
      return state -> value.apply(state).get(index);
    }
  }

  /** Forces, then torques. */
  record OfWrench(Function<ControllerState, Wrench> value) implements Getter {
    @Override
    public void read(ControllerState state, double[] out, int at) {
      Wrench wrench = value.apply(state);
      out[at] = wrench.fx();
      out[at + 1] = wrench.fy();
      out[at + 2] = wrench.fz();
      out[at + 3] = wrench.mx();
      out[at + 4] = wrench.my();
      out[at + 5] = wrench.mz();
    }

    @Override
    public ToDoubleFunction<ControllerState> element(int index) {
      return switch (index) {
        case 0 -> state -> value.apply(state).fx();
        case 1 -> state -> value.apply(state).fy();
        case 2 -> state -> value.apply(state).fz();
        case 3 -> state -> value.apply(state).mx();
        case 4 -> state -> value.apply(state).my();
        case 5 -> state -> value.apply(state).mz();
        default -> throw new IndexOutOfBoundsException("index is " + index + ", must be 0 to 5");
      };
    }
  }

  /** All registers of a kind. */
  record OfRegisters(RegisterDirection direction, RegisterKind kind) implements Getter {
    @Override
    public void read(ControllerState state, double[] out, int at) {
      state.signals().registers(direction).read(kind, out, at);
    }

    @Override
    public ToDoubleFunction<ControllerState> element(int index) {
      return switch (kind) {
        case BOOLEAN -> state -> state.signals().registers(direction).bool(index) ? 1 : 0;
        case INTEGER -> state -> state.signals().registers(direction).integer(index);
        case FLOAT -> state -> state.signals().registers(direction).floating(index);
      };
    }
  }
}
