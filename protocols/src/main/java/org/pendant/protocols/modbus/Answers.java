package org.pendant.protocols.modbus;

import com.ghgande.j2mod.modbus.msg.ExceptionResponse;
import com.ghgande.j2mod.modbus.msg.MaskWriteRegisterRequest;
import com.ghgande.j2mod.modbus.msg.MaskWriteRegisterResponse;
import com.ghgande.j2mod.modbus.msg.ModbusRequest;
import com.ghgande.j2mod.modbus.msg.ModbusResponse;
import com.ghgande.j2mod.modbus.msg.ReadCoilsRequest;
import com.ghgande.j2mod.modbus.msg.ReadCoilsResponse;
import com.ghgande.j2mod.modbus.msg.ReadInputDiscretesRequest;
import com.ghgande.j2mod.modbus.msg.ReadInputDiscretesResponse;
import com.ghgande.j2mod.modbus.msg.ReadInputRegistersRequest;
import com.ghgande.j2mod.modbus.msg.ReadInputRegistersResponse;
import com.ghgande.j2mod.modbus.msg.ReadMultipleRegistersRequest;
import com.ghgande.j2mod.modbus.msg.ReadMultipleRegistersResponse;
import com.ghgande.j2mod.modbus.msg.ReadWriteMultipleRequest;
import com.ghgande.j2mod.modbus.msg.ReadWriteMultipleResponse;
import com.ghgande.j2mod.modbus.msg.WriteCoilRequest;
import com.ghgande.j2mod.modbus.msg.WriteCoilResponse;
import com.ghgande.j2mod.modbus.msg.WriteMultipleCoilsRequest;
import com.ghgande.j2mod.modbus.msg.WriteMultipleCoilsResponse;
import com.ghgande.j2mod.modbus.msg.WriteMultipleRegistersRequest;
import com.ghgande.j2mod.modbus.msg.WriteMultipleRegistersResponse;
import com.ghgande.j2mod.modbus.msg.WriteSingleRegisterRequest;
import com.ghgande.j2mod.modbus.msg.WriteSingleRegisterResponse;
import com.ghgande.j2mod.modbus.util.BitVector;
import java.util.List;
import java.util.concurrent.locks.ReadWriteLock;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.modbus.RefusedRequest.Reason;

/** Request execution: carries out requests on a box. Any thread, one request at a time. */
final class Answers {
  /** The box behind a server. */
  interface Box {
    /** The newest snapshot. */
    ControllerState state();

    /**
     * Changes signals, all or none, and waits until that can be read.
     *
     * @throws RefusedRequest if the box refuses
     */
    void write(List<SignalWrite> writes) throws RefusedRequest;
  }

  private final Box box;
  private final ReadWriteLock changing;

  /**
   * For one client.
   *
   * @param changing shared by all clients: held alone by who changes bits of a register, so that
   *     this does not undo what others write meanwhile
   */
  Answers(Box box, ReadWriteLock changing) {
    this.box = box;
    this.changing = changing;
  }

  /** The answer to a whole frame, which may be an exception of the protocol. */
  byte[] answer(byte[] frame) {
    ModbusResponse response;
    try {
      RequestCheck.check(frame);
      response = carryOut(FrameCodec.decode(frame));
    } catch (RefusedRequest e) {
      // the mark of an exception is the function's highest bit, whether it is set already or not
      int function = RequestCheck.function(frame) & 0x7F;
      response = new ExceptionResponse(function, e.reason().number());
    }
    return FrameCodec.encode(response, frame);
  }

  private ModbusResponse carryOut(ModbusRequest request) throws RefusedRequest {
    return switch (request) {
      case ReadCoilsRequest read -> readCoils(read);
      case ReadInputDiscretesRequest read -> readInputs(read);
      case ReadMultipleRegistersRequest read ->
          new ReadMultipleRegistersResponse(
              RegisterMap.registers(box.state(), read.getReference(), read.getWordCount()));
      case ReadInputRegistersRequest read ->
          new ReadInputRegistersResponse(
              RegisterMap.registers(box.state(), read.getReference(), read.getWordCount()));
      case WriteCoilRequest write -> {
        write(RegisterMap.writes(write.getReference(), write.getCoil()));
        yield new WriteCoilResponse(write.getReference(), write.getCoil());
      }
      case WriteSingleRegisterRequest write -> {
        int value = write.getRegister().toUnsignedShort();
        write(RegisterMap.writes(write.getReference(), value));
        yield new WriteSingleRegisterResponse(write.getReference(), value);
      }
      case WriteMultipleCoilsRequest write -> {
        write(RegisterMap.writes(write.getReference(), write.getCoils(), write.getBitCount()));
        // the constructor with these two forgets the function
        WriteMultipleCoilsResponse response = (WriteMultipleCoilsResponse) write.getResponse();
        response.setReference(write.getReference());
        response.setBitCount(write.getBitCount());
        yield response;
      }
      case WriteMultipleRegistersRequest write -> {
        write(RegisterMap.writes(write.getReference(), write.getRegisters()));
        yield new WriteMultipleRegistersResponse(write.getReference(), write.getWordCount());
      }
      case MaskWriteRegisterRequest mask -> maskWrite(mask);
      case ReadWriteMultipleRequest both -> readAndWrite(both);
      // the check lets nothing else through
      default -> throw new RefusedRequest(Reason.FUNCTION);
    };
  }

  private void write(List<SignalWrite> writes) throws RefusedRequest {
    changing.readLock().lock();
    try {
      box.write(writes);
    } finally {
      changing.readLock().unlock();
    }
  }

  private ModbusResponse readCoils(ReadCoilsRequest read) throws RefusedRequest {
    BitVector bits = RegisterMap.bits(box.state(), read.getReference(), read.getBitCount());
    ReadCoilsResponse response = new ReadCoilsResponse(read.getBitCount());
    for (int i = 0; i < read.getBitCount(); i++) {
      response.setCoilStatus(i, bits.getBit(i));
    }
    return response;
  }

  private ModbusResponse readInputs(ReadInputDiscretesRequest read) throws RefusedRequest {
    BitVector bits = RegisterMap.bits(box.state(), read.getReference(), read.getBitCount());
    ReadInputDiscretesResponse response = new ReadInputDiscretesResponse(read.getBitCount());
    for (int i = 0; i < read.getBitCount(); i++) {
      response.setDiscreteStatus(i, bits.getBit(i));
    }
    return response;
  }

  private ModbusResponse maskWrite(MaskWriteRegisterRequest mask) throws RefusedRequest {
    int address = mask.getReference();
    int and = mask.getAndMask();
    int or = mask.getOrMask();
    changing.writeLock().lock();
    try {
      int value = (RegisterMap.register(box.state(), address) & and) | (or & ~and);
      box.write(RegisterMap.writes(address, value & 0xFFFF));
    } finally {
      changing.writeLock().unlock();
    }
    MaskWriteRegisterResponse response = new MaskWriteRegisterResponse();
    response.setReference(address);
    response.setAndMask(and);
    response.setOrMask(or);
    return response;
  }

  /** Writes first, then reads (protocol, 6.17). */
  private ModbusResponse readAndWrite(ReadWriteMultipleRequest both) throws RefusedRequest {
    // nothing may be written when the registers to read are not there
    RegisterMap.registers(box.state(), both.getReadReference(), both.getReadWordCount());
    write(RegisterMap.writes(both.getWriteReference(), both.getRegisters()));
    return new ReadWriteMultipleResponse(
        RegisterMap.registers(box.state(), both.getReadReference(), both.getReadWordCount()));
  }
}
