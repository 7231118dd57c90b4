package org.pendant.protocols.modbusclient;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.pendant.protocols.Peer;

/** A Modbus device with 1,000 registers and as many coils, which the inputs show as well. */
final class FakeDevice implements Peer.Conversation {
  private final int[] registers = new int[1000];
  private final boolean[] coils = new boolean[1000];
  private final List<String> asked = new CopyOnWriteArrayList<>();
  private volatile int exception;
  private volatile int mostWaiting;

  /** What it was asked: unit, function, address, count or value. */
  List<String> asked() {
    return asked;
  }

  /** It refuses everything with this code from now on; 0 for no more. */
  void refuse(int code) {
    exception = code;
  }

  /** How many questions have waited at most while it answered one. */
  int mostWaiting() {
    return mostWaiting;
  }

  synchronized int register(int address) {
    return registers[address];
  }

  synchronized void setRegister(int address, int value) {
    registers[address] = value;
  }

  synchronized boolean coil(int address) {
    return coils[address];
  }

  synchronized void setCoil(int address, boolean value) {
    coils[address] = value;
  }

  @Override
  public void with(Socket client) throws IOException {
    DataInputStream in = new DataInputStream(client.getInputStream());
    OutputStream out = client.getOutputStream();
    while (true) {
      byte[] question = read(in);
      mostWaiting = Math.max(mostWaiting, in.available() / 12);
      out.write(answer(question));
    }
  }

  /** The next question, with its prefix. */
  static byte[] read(DataInputStream in) throws IOException {
    byte[] prefix = in.readNBytes(6);
    if (prefix.length < 6) {
      throw new EOFException();
    }
    byte[] rest = in.readNBytes(ByteBuffer.wrap(prefix).getShort(4));
    return ByteBuffer.allocate(6 + rest.length).put(prefix).put(rest).array();
  }

  /** The answer to a question, with its prefix. */
  synchronized byte[] answer(byte[] question) {
    ByteBuffer in = ByteBuffer.wrap(question);
    int unit = in.get(6) & 0xFF;
    int function = in.get(7) & 0xFF;
    int address = in.getShort(8) & 0xFFFF;
    int count = in.getShort(10) & 0xFFFF;
    asked.add(unit + " " + function + " " + address + " " + count);
    ByteBuffer out = ByteBuffer.allocate(260).put(question, 0, 8);
    if (exception != 0) {
      out.put(7, (byte) (function | 0x80)).put((byte) exception);
      return framed(out);
    }
    switch (function) {
      case 1, 2 -> readBits(out, address, count);
      case 3, 4 -> readRegisters(out, address, count);
      case 6 -> {
        registers[address] = count;
        out.put(question, 8, 4);
      }
      case 15 -> {
        for (int i = 0; i < count; i++) {
          coils[address + i] = (question[13 + i / 8] >> i % 8 & 1) != 0;
        }
        out.put(question, 8, 4);
      }
      case 16 -> {
        writeRegisters(in, 13, address, count);
        out.put(question, 8, 4);
      }
      case 23 -> {
        writeRegisters(in, 17, in.getShort(12), in.getShort(14));
        readRegisters(out, address, count);
      }
      default -> out.put(7, (byte) (function | 0x80)).put((byte) 1);
    }
    return framed(out);
  }

  private void readBits(ByteBuffer out, int address, int count) {
    byte[] bits = new byte[(count + 7) / 8];
    for (int i = 0; i < count; i++) {
      bits[i / 8] |= (byte) (coils[address + i] ? 1 << i % 8 : 0);
    }
    out.put((byte) bits.length).put(bits);
  }

  private void readRegisters(ByteBuffer out, int address, int count) {
    out.put((byte) (2 * count));
    for (int i = 0; i < count; i++) {
      out.putShort((short) registers[address + i]);
    }
  }

  private void writeRegisters(ByteBuffer in, int offset, int address, int count) {
    for (int i = 0; i < count; i++) {
      registers[address + i] = in.getShort(offset + 2 * i) & 0xFFFF;
    }
  }

  private static byte[] framed(ByteBuffer out) {
    byte[] frame = new byte[out.position()];
    out.putShort(4, (short) (frame.length - 6)).flip().get(frame);
    return frame;
  }
}
