package org.pendant.recording;

import java.util.Optional;
import org.pendant.controller.box.Mounting;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.freedrive.FreedriveHolder;
import org.pendant.controller.freedrive.FreedriveMode;
import org.pendant.controller.freedrive.FreedriveState;
import org.pendant.controller.freedrive.SingularityDistance;
import org.pendant.controller.state.ControlMode;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.motion.MotionFailure;

/** Forms of what belongs to the arm. */
final class ArmForms {
  static final Form<Pose> POSE =
      new Form<>() {
        @Override
        void write(Pose value, ByteSink out) {
          for (int i = 0; i < Pose.SIZE; i++) {
            out.number(value.get(i));
          }
        }

        @Override
        Pose read(ByteSource in) throws MalformedBytes {
          return new Pose(
              in.number(), in.number(), in.number(), in.number(), in.number(), in.number());
        }
      };

  static final Form<Joints> JOINTS =
      new Form<>() {
        @Override
        void write(Joints value, ByteSink out) {
          for (int i = 0; i < Joints.COUNT; i++) {
            out.number(value.get(i));
          }
        }

        @Override
        Joints read(ByteSource in) throws MalformedBytes {
          return new Joints(
              in.number(), in.number(), in.number(), in.number(), in.number(), in.number());
        }
      };

  static final Form<ToolCentre> TOOL =
      new Form<>() {
        @Override
        void write(ToolCentre value, ByteSink out) {
          POSE.write(value.inFlange(), out);
          out.text(value.name());
        }

        @Override
        ToolCentre read(ByteSource in) throws MalformedBytes {
          return new ToolCentre(POSE.read(in), in.text());
        }
      };

  static final Form<ControlStatus> CONTROL =
      new Form<>() {
        @Override
        void write(ControlStatus value, ByteSink out) {
          out.constant(value.mode());
          out.bool(value.moving());
          out.bool(value.steady());
        }

        @Override
        ControlStatus read(ByteSource in) throws MalformedBytes {
          return ControlStatus.of(in.constant(ControlMode.class), in.bool(), in.bool());
        }
      };

  static final Form<Optional<MotionFailure>> FAULT =
      new Form<MotionFailure>() {
        @Override
        void write(MotionFailure value, ByteSink out) {
          out.text(value.code());
          out.text(value.message());
        }

        @Override
        MotionFailure read(ByteSource in) throws MalformedBytes {
          return new MotionFailure(in.text(), in.text());
        }
      }.optional();

  static final Form<Payload> PAYLOAD =
      new Form<>() {
        @Override
        void write(Payload value, ByteSink out) {
          out.number(value.massKg());
          out.number(value.cogXM());
          out.number(value.cogYM());
          out.number(value.cogZM());
          out.number(value.ixx());
          out.number(value.iyy());
          out.number(value.izz());
          out.number(value.ixy());
          out.number(value.ixz());
          out.number(value.iyz());
        }

        @Override
        Payload read(ByteSource in) throws MalformedBytes {
          return new Payload(
              in.number(),
              in.number(),
              in.number(),
              in.number(),
              in.number(),
              in.number(),
              in.number(),
              in.number(),
              in.number(),
              in.number());
        }
      };

  static final Form<Mounting> MOUNTING =
      new Form<>() {
        @Override
        void write(Mounting value, ByteSink out) {
          out.number(value.gravityXMPerS2());
          out.number(value.gravityYMPerS2());
          out.number(value.gravityZMPerS2());
          out.number(value.accelerationXMPerS2());
          out.number(value.accelerationYMPerS2());
          out.number(value.accelerationZMPerS2());
        }

        @Override
        Mounting read(ByteSource in) throws MalformedBytes {
          return new Mounting(
              in.number(), in.number(), in.number(), in.number(), in.number(), in.number());
        }
      };

  private static final Form<FreeAxes> AXES =
      new Form<>() {
        @Override
        void write(FreeAxes value, ByteSink out) {
          for (int i = 0; i < FreeAxes.COUNT; i++) {
            out.bool(value.free(i));
          }
        }

        @Override
        FreeAxes read(ByteSource in) throws MalformedBytes {
          return new FreeAxes(in.bool(), in.bool(), in.bool(), in.bool(), in.bool(), in.bool());
        }
      };

  private static final Form<FreedriveFrame> FRAME =
      new Form<>() {
        @Override
        void write(FreedriveFrame value, ByteSink out) {
          switch (value) {
            case FreedriveFrame.Base base -> out.byteOf(0);
            case FreedriveFrame.Tool tool -> out.byteOf(1);
            case FreedriveFrame.Feature feature -> {
              out.byteOf(2);
              POSE.write(feature.inBase(), out);
            }
          }
        }

        @Override
        FreedriveFrame read(ByteSource in) throws MalformedBytes {
          return switch (in.upTo(2)) {
            case 0 -> FreedriveFrame.BASE;
            case 1 -> FreedriveFrame.TOOL;
            default -> new FreedriveFrame.Feature(POSE.read(in));
          };
        }
      };

  private static final Form<Optional<FreedriveMode>> MODE =
      new Form<FreedriveMode>() {
        @Override
        void write(FreedriveMode value, ByteSink out) {
          out.constant(value.holder());
          AXES.write(value.axes(), out);
          FRAME.write(value.frame(), out);
          out.bool(value.payloadChecked());
        }

        @Override
        FreedriveMode read(ByteSource in) throws MalformedBytes {
          return new FreedriveMode(
              in.constant(FreedriveHolder.class), AXES.read(in), FRAME.read(in), in.bool());
        }
      }.optional();

  static final Form<FreedriveState> FREEDRIVE =
      new Form<>() {
        @Override
        void write(FreedriveState value, ByteSink out) {
          MODE.write(value.mode(), out);
          out.constant(value.distance());
        }

        @Override
        FreedriveState read(ByteSource in) throws MalformedBytes {
          return new FreedriveState(MODE.read(in), in.constant(SingularityDistance.class));
        }
      };

  private ArmForms() {}
}
