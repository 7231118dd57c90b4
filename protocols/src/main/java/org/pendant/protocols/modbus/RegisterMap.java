package org.pendant.protocols.modbus;

import com.ghgande.j2mod.modbus.procimg.Register;
import com.ghgande.j2mod.modbus.procimg.SimpleRegister;
import com.ghgande.j2mod.modbus.util.BitVector;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.io.PortMap;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.quantity.PortImage;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.modbus.RefusedRequest.Reason;

/**
 * Register map: ranges of the registers and bits of {@link PortImage}; one address that does not
 * exist refuses all.
 */
final class RegisterMap {
  private static final int FULL = 0xFFFF;

  private RegisterMap() {}

  /** Registers as they are in {@code state}. */
  static Register[] registers(ControllerState state, int address, int count) throws RefusedRequest {
    Register[] registers = new Register[count];
    for (int i = 0; i < count; i++) {
      registers[i] = new SimpleRegister(register(state, address + i));
    }
    return registers;
  }

  /** A register as it is in {@code state}, 0 to 65535. */
  static int register(ControllerState state, int address) throws RefusedRequest {
    return there(PortImage.register(address, state));
  }

  /** Bits as they are in {@code state}. */
  static BitVector bits(ControllerState state, int address, int count) throws RefusedRequest {
    BitVector bits = new BitVector(count);
    for (int i = 0; i < count; i++) {
      bits.setBit(i, there(PortImage.bit(address + i, state)));
    }
    return bits;
  }

  /** What writing registers changes. */
  static List<SignalWrite> writes(int address, Register[] registers) throws RefusedRequest {
    List<SignalWrite> writes = new ArrayList<>();
    for (int i = 0; i < registers.length; i++) {
      writes.addAll(writes(address + i, registers[i].toUnsignedShort()));
    }
    return writes;
  }

  /** What writing a register changes; nothing where a mask is 0. */
  static List<SignalWrite> writes(int address, int value) throws RefusedRequest {
    try {
      List<SignalWrite> writes = there(PortMap.writeRegister(address, value));
      if (writes.isEmpty()) {
        // a register that takes a mask changes something with all bits set, one to read never does
        writable(there(PortMap.writeRegister(address, FULL)));
      }
      return writes;
    } catch (IllegalArgumentException e) {
      // the register is there, the value is none of its values
      throw new RefusedRequest(Reason.VALUE);
    }
  }

  /** What writing bits changes. */
  static List<SignalWrite> writes(int address, BitVector bits, int count) throws RefusedRequest {
    List<SignalWrite> writes = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      writes.addAll(writes(address + i, bits.getBit(i)));
    }
    return writes;
  }

  /** What writing a bit changes. */
  static List<SignalWrite> writes(int address, boolean value) throws RefusedRequest {
    List<SignalWrite> writes = there(PortMap.writeBit(address, value));
    writable(writes);
    return writes;
  }

  private static void writable(List<SignalWrite> writes) throws RefusedRequest {
    if (writes.isEmpty()) {
      throw new RefusedRequest(Reason.ADDRESS);
    }
  }

  private static <T> T there(Optional<T> found) throws RefusedRequest {
    return found.orElseThrow(() -> new RefusedRequest(Reason.ADDRESS));
  }
}
