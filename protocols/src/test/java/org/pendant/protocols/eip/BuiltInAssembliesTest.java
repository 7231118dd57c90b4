package org.pendant.protocols.eip;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.rtde.ControlAssembly;
import org.pendant.controller.rtde.InputUpdate;
import org.pendant.controller.rtde.RtdeCommand;
import org.pendant.controller.state.ControllerState;

class BuiltInAssembliesTest {
  private static final long SEED = 20_261_122;

  private final Controller controller =
      new Controller(
          ControllerOptions.headless()
              .withInputs(Map.of("digital_in[1]", true, "configurable_in[7]", true)));

  private void done(Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    controller.advance();
    assertEquals(new Reply.Done(), reply.getNow(new Reply.Busy("no reply")));
  }

  @Test
  void theStateHasEveryFieldInItsPlace() {
    done(
        new IoCommand.WriteSignals(
            "test",
            List.of(
                new SignalWrite.BooleanRegister(RegisterDirection.OUTPUT, 63, true),
                new SignalWrite.IntegerRegister(RegisterDirection.OUTPUT, 0, -7),
                new SignalWrite.IntegerRegister(RegisterDirection.OUTPUT, 23, 23),
                new SignalWrite.FloatRegister(RegisterDirection.OUTPUT, 0, 0.5),
                new SignalWrite.FloatRegister(RegisterDirection.OUTPUT, 23, 2.5))));
    done(new BoxCommand.SetSpeedFraction(0.25));
    ControllerState state = controller.state();
    ByteBuffer data = new StateAssembly().of(state);
    assertEquals(480, data.remaining());
    assertEquals(5, data.get(0));
    assertEquals(24, data.get(1));
    assertEquals(7, data.get(4));
    assertEquals(4, data.getShort(6), "milliseconds");
    assertEquals(1, data.getInt(16), "power is on");
    assertEquals(0.25f, data.getFloat(20));
    assertEquals(1, data.get(24));
    assertEquals(1, data.getShort(28));
    assertEquals(2, data.get(32));
    assertEquals(0x80, Byte.toUnsignedInt(data.get(33)));
    assertEquals((float) state.arm().actualPositionRad().get(5), data.getFloat(120));
    assertEquals((float) state.readings().temperatureC().get(0), data.getFloat(172));
    assertEquals(253, Byte.toUnsignedInt(data.get(196)));
    assertEquals((float) state.geometry().actualTcpInBase().x(), data.getFloat(204));
    assertEquals((float) state.readings().flangeWrenchInBase().fx(), data.getFloat(252));
    assertEquals(1L << 63, data.getLong(280));
    assertEquals(-7, data.getInt(288));
    assertEquals(23, data.getInt(380));
    assertEquals(0.5f, data.getFloat(384));
    assertEquals(2.5f, data.getFloat(476));
  }

  @Test
  void controlReachesSliderOutputsAndRegisters() {
    ByteBuffer data = ByteBuffer.allocate(224).order(ByteOrder.LITTLE_ENDIAN);
    data.putInt(0, 1).putFloat(4, 0.5f);
    data.put(8, (byte) 0x03).put(9, (byte) 0x80).put(10, (byte) 0x01).put(11, (byte) 0xFF);
    data.put(12, (byte) 1).put(13, (byte) 1).put(14, (byte) 2).put(15, (byte) 2);
    data.putFloat(16, 0.75f);
    data.putInt(24, 0x8000_0001).putInt(28, 11).putInt(72, -11).putFloat(76, 1.5f);
    data.putInt(124, 2).putInt(128, 12).putInt(172, 23).putFloat(220, 23.5f);
    InputUpdate update = ControlAssembly.decode(data);
    assertEquals(OptionalDouble.of(0.5), update.speedFraction());
    done(new RtdeCommand.WriteInputs("scanner", update));
    ControllerState state = controller.state();
    assertEquals(0.5, state.arm().speedFraction());
    assertEquals(0x01, state.io().standardOut());
    assertEquals(0x80, state.io().configurableOut());
    assertEquals(0x02, state.io().toolOut());
    assertEquals(7.5, state.signals().analog().signal(AnalogBank.STANDARD_OUT, 0).value(), 1e-6);
    assertTrue(state.signals().registers(RegisterDirection.INPUT).bool(0));
    assertTrue(state.signals().registers(RegisterDirection.INPUT).bool(31));
    assertTrue(state.signals().registers(RegisterDirection.INPUT).bool(33));
    assertEquals(11, state.signals().registers(RegisterDirection.INPUT).integer(0));
    assertEquals(-11, state.signals().registers(RegisterDirection.INPUT).integer(11));
    assertEquals(12, state.signals().registers(RegisterDirection.INPUT).integer(12));
    assertEquals(23, state.signals().registers(RegisterDirection.INPUT).integer(23));
    assertEquals(1.5, state.signals().registers(RegisterDirection.INPUT).floating(0));
    assertEquals(23.5, state.signals().registers(RegisterDirection.INPUT).floating(23));
  }

  @Test
  void anyControlDataCanBeTaken() {
    Random random = new Random(SEED);
    for (int i = 0; i < 1000; i++) {
      byte[] noise = new byte[ControlAssembly.BYTES];
      random.nextBytes(noise);
      InputUpdate update = ControlAssembly.decode(ByteBuffer.wrap(noise));
      done(new RtdeCommand.WriteInputs("scanner", update));
    }
  }
}
