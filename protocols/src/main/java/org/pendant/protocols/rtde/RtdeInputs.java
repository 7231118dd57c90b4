package org.pendant.protocols.rtde;

import static org.pendant.protocols.rtde.RtdeTexts.text;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.pendant.controller.rtde.FieldType;
import org.pendant.protocols.rtde.RtdeClient.InputsGranted;
import org.pendant.protocols.rtde.RtdeClient.Subscription;

/**
 * RTDE inputs: writes inputs of a controller, of Pendant's or of a real robot, over a connection of
 * its own. An input is taken when it is first written, and given back when this is closed. One
 * thread uses it.
 */
public final class RtdeInputs implements Closeable {
  /** Something has to come, as controllers take inputs while they send. */
  private static final List<String> SOMETHING = List.of("timestamp");

  private static final double SELDOM_HZ = 1;

  private final RtdeClient client;
  private final Map<List<String>, InputsGranted> taken = new HashMap<>();
  private boolean started;

  private RtdeInputs(RtdeClient client) {
    this.client = client;
  }

  /**
   * Connects.
   *
   * @throws IOException if nothing is reached there, or something that does not speak RTDE
   */
  public static RtdeInputs connect(InetSocketAddress address) throws IOException {
    RtdeClient client = RtdeClient.connect(address);
    try {
      if (client.subscribe(SELDOM_HZ, SOMETHING) instanceof Subscription.Granted) {
        return new RtdeInputs(client);
      }
      throw new IOException(text("noTimeTold"));
    } catch (IOException e) {
      client.close();
      throw e;
    }
  }

  /**
   * Writes inputs, all in one step of the controller.
   *
   * @param names such as {@code input_int_register_3}
   * @param numbers their values, 1 and 0 for true and false
   * @throws IOException if the controller refuses them or the connection is lost
   */
  public void write(List<String> names, List<Double> numbers) throws IOException {
    InputsGranted granted = taken.get(names);
    if (granted == null) {
      if (started) {
        client.pause();
        started = false;
      }
      granted = client.takeInputs(names);
      taken.put(List.copyOf(names), granted);
    }
    if (!started) {
      client.start();
      started = true;
    }
    int bytes = 1;
    for (FieldType each : granted.types()) {
      bytes += each.bytes();
    }
    byte[] whole = ReplyCodec.packet(PacketType.DATA, bytes).array();
    ByteBuffer packet = ByteBuffer.wrap(whole).position(Packet.HEADER_BYTES);
    packet.put((byte) granted.number());
    for (int i = 0; i < names.size(); i++) {
      put(packet, granted.types().get(i), numbers.get(i));
    }
    client.send(whole);
  }

  private static void put(ByteBuffer packet, FieldType type, double number) throws IOException {
    switch (type) {
      case BOOL, UINT8 -> packet.put((byte) (long) number);
      case UINT32, INT32 -> packet.putInt((int) (long) number);
      case UINT64 -> packet.putLong((long) number);
      case DOUBLE -> packet.putDouble(number);
      case VECTOR3D, VECTOR6D, VECTOR6INT32, VECTOR6UINT32 ->
          throw new IOException(text("inputNeedsSixNumbers"));
    }
  }

  @Override
  public void close() throws IOException {
    client.close();
  }
}
