package org.pendant.client;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/** A client that reads what comes every 2 ms, in a thread of its own, and notes when. */
final class Receiver implements AutoCloseable {
  /** What ur_rtde asks for when nothing else is said, as far as it matters here. */
  private static final String FIELDS =
      "timestamp,target_q,target_qd,target_qdd,target_current,target_moment,actual_q,actual_qd,"
          + "actual_current,joint_control_output,actual_TCP_pose,actual_TCP_speed,"
          + "actual_TCP_force,target_TCP_pose,target_TCP_speed,actual_digital_input_bits,"
          + "joint_temperatures,actual_execution_time,robot_mode,joint_mode,safety_mode,"
          + "actual_tool_accelerometer,speed_scaling,target_speed_fraction,actual_momentum,"
          + "actual_main_voltage,actual_robot_voltage,actual_robot_current,actual_joint_voltage,"
          + "actual_digital_output_bits,runtime_state,robot_status_bits,safety_status_bits,"
          + "standard_analog_input0,standard_analog_input1,standard_analog_output0,"
          + "standard_analog_output1,output_int_register_0,output_double_register_0";

  private static final double FRAME_S = 0.002;
  private static final int RTDE_HEADER = 3;
  private static final int DATA = 'U';

  /** Length of a message and, by its first number, the robot's time; the head is read already. */
  private interface Framing {
    /** Reads a message; its time in s, or NaN when it is none that comes every 2 ms. */
    double read(DataInputStream input) throws IOException;
  }

  private final Socket socket;
  private final DataInputStream input;
  private final Framing framing;
  private final Thread thread;
  private volatile Stopwatch stopwatch = new Stopwatch(0);
  private volatile boolean ended;
  private volatile int gaps;
  private volatile long missed;
  private volatile long received;

  private Receiver(Socket socket, Framing framing) throws IOException {
    this.socket = socket;
    this.framing = framing;
    input = new DataInputStream(new BufferedInputStream(socket.getInputStream(), 1 << 16));
    thread = Thread.ofPlatform().daemon().name("receiver").unstarted(this::run);
  }

  /** An RTDE client with a full recipe at 500 Hz; it has started. */
  static Receiver rtde(String host) throws IOException {
    Socket socket = new Socket(host, 30004);
    Receiver receiver = new Receiver(socket, Receiver::readRtde);
    startRtde(socket.getOutputStream());
    receiver.thread.start();
    return receiver;
  }

  /** Asks for a full recipe at 500 Hz, without reading any answer. */
  static void startRtde(OutputStream output) throws IOException {
    byte[] names = FIELDS.getBytes(StandardCharsets.ISO_8859_1);
    output.write(
        ByteBuffer.allocate(2 * RTDE_HEADER + 2 + Double.BYTES + names.length + RTDE_HEADER)
            .putShort((short) (RTDE_HEADER + 2))
            .put((byte) 'V')
            .putShort((short) 2)
            .putShort((short) (RTDE_HEADER + Double.BYTES + names.length))
            .put((byte) 'O')
            .putDouble(500)
            .put(names)
            .putShort((short) RTDE_HEADER)
            .put((byte) 'S')
            .array());
  }

  /** A client of something that sends packages like those of the real-time port. */
  static Receiver realtime(String host, int port) throws IOException {
    Receiver receiver = new Receiver(new Socket(host, port), Receiver::readRealtime);
    receiver.thread.start();
    return receiver;
  }

  private static double readRtde(DataInputStream input) throws IOException {
    int size = input.readUnsignedShort();
    int type = input.readUnsignedByte();
    if (type != DATA) {
      input.skipNBytes(size - RTDE_HEADER);
      return Double.NaN;
    }
    input.readByte();
    double timeS = input.readDouble();
    input.skipNBytes(size - RTDE_HEADER - 1 - Double.BYTES);
    return timeS;
  }

  private static double readRealtime(DataInputStream input) throws IOException {
    int size = input.readInt();
    double timeS = input.readDouble();
    input.skipNBytes(size - Integer.BYTES - Double.BYTES);
    return timeS;
  }

  private void run() {
    try {
      double beforeS = Double.NaN;
      while (true) {
        double timeS = framing.read(input);
        if (!Double.isNaN(timeS)) {
          stopwatch.arrived();
          count(timeS - beforeS);
          beforeS = timeS;
        }
      }
    } catch (IOException e) {
      // closed by either side
      ended = true;
    }
  }

  /** Only this thread writes what is counted. */
  @SuppressWarnings("NonAtomicVolatileUpdate")
  private void count(double intervalS) {
    received++;
    if (intervalS > 1.5 * FRAME_S) {
      gaps++;
      missed += Math.round(intervalS / FRAME_S) - 1;
    }
  }

  /** Measures from now on, for at most this long. */
  void measure(int mostMessages) {
    stopwatch = new Stopwatch(mostMessages);
  }

  /** What was measured. */
  Stopwatch stopwatch() {
    return stopwatch;
  }

  /** How often a message was missing, since the begin. */
  int gaps() {
    return gaps;
  }

  /** How many messages were missing, since the begin. */
  long missed() {
    return missed;
  }

  /** How many messages have come, since the begin. */
  long received() {
    return received;
  }

  /** Whether the connection has ended. */
  boolean ended() {
    return ended;
  }

  @Override
  public void close() {
    try {
      socket.close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
