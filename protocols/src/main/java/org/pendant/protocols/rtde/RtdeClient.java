package org.pendant.protocols.rtde;

import static org.pendant.protocols.rtde.RtdeTexts.text;

import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.pendant.controller.rtde.FieldType;
import org.pendant.protocols.net.ProtocolException;

/**
 * RTDE client: receives fields of a controller, of Pendant's or of a real robot, by version 2 of
 * the protocol. One thread uses it.
 */
public final class RtdeClient implements Closeable {
  private static final int VERSION = 2;

  /** A controller that has not answered by then is none. */
  private static final int ANSWER_MS = 5_000;

  /** How long {@link #next} waits for data. */
  private static final int WAIT_MS = 100;

  private static final int BUFFER_BYTES = 1 << 16;
  private static final int VERSION_NUMBERS = 4;
  private static final String NOT_FOUND = "NOT_FOUND";

  private final Socket socket;
  private final PacketCutter cutter = new PacketCutter();
  private final byte[] buffer = new byte[BUFFER_BYTES];
  private ByteBuffer unread = ByteBuffer.allocate(0);

  /** What the controller said last, which explains a refusal. */
  private Optional<String> said = Optional.empty();

  private int recipe;
  private int dataBytes;

  private RtdeClient(Socket socket) {
    this.socket = socket;
  }

  /**
   * Connects and agrees on the version of the protocol.
   *
   * @throws IOException if nothing is reached there, or something that does not speak RTDE
   */
  public static RtdeClient connect(InetSocketAddress address) throws IOException {
    RtdeClient client = new RtdeClient(new Socket());
    try {
      client.socket.connect(address, ANSWER_MS);
      client.socket.setTcpNoDelay(true);
      client.socket.setSoTimeout(WAIT_MS);
      client.agree();
      return client;
    } catch (IOException e) {
      client.close();
      throw e;
    }
  }

  private void agree() throws IOException {
    byte[] request = ReplyCodec.packet(PacketType.PROTOCOL_VERSION, Short.BYTES).array();
    request[request.length - 1] = VERSION;
    if (!accepted(ask(PacketType.PROTOCOL_VERSION, request))) {
      throw new IOException(text("versionNotSpoken", VERSION));
    }
  }

  /**
   * The software version of the controller, such as {@code 5.24.1.0}.
   *
   * @throws IOException if the connection is lost or there is no such answer
   */
  public String controllerVersion() throws IOException {
    byte[] request = ReplyCodec.packet(PacketType.CONTROLLER_VERSION, 0).array();
    ByteBuffer answer = ask(PacketType.CONTROLLER_VERSION, request);
    if (answer.remaining() < VERSION_NUMBERS * Integer.BYTES) {
      throw new IOException(text("noVersionNamed", hex(answer)));
    }
    List<String> numbers = new ArrayList<>();
    for (int i = 0; i < VERSION_NUMBERS; i++) {
      numbers.add(Integer.toUnsignedString(answer.getInt()));
    }
    return String.join(".", numbers);
  }

  /** What becomes of a wish for fields. */
  public sealed interface Subscription {
    /** The fields will come, in the order of the wish. */
    record Granted(List<ReceivedField> fields) implements Subscription {
      /** Copies the list. */
      public Granted {
        fields = List.copyOf(fields);
      }
    }

    /** The controller does not have these, and none will come. */
    record Unknown(List<String> names) implements Subscription {
      /** Copies the list. */
      public Unknown {
        names = List.copyOf(names);
      }
    }
  }

  /**
   * Asks for fields; it may be asked again while none are sent.
   *
   * @param frequencyHz how often they shall come, above 0 to 500 Hz
   * @param names such as {@code actual_q}
   * @throws IOException if the controller refuses the wish as a whole, or the connection is lost
   */
  public Subscription subscribe(double frequencyHz, List<String> names) throws IOException {
    byte[] text = String.join(",", names).getBytes(StandardCharsets.ISO_8859_1);
    int bytes = Packet.HEADER_BYTES + Double.BYTES + text.length;
    if (bytes > Packet.MAX_BYTES) {
      throw new IOException(text("fieldNamesTooLong", text.length));
    }
    byte[] request =
        ReplyCodec.packet(PacketType.SETUP_OUTPUTS, Double.BYTES + text.length)
            .putDouble(frequencyHz)
            .put(text)
            .array();
    ByteBuffer answer = ask(PacketType.SETUP_OUTPUTS, request);
    if (!answer.hasRemaining()) {
      throw new IOException(text("fieldsAnswerEmpty"));
    }
    recipe = Byte.toUnsignedInt(answer.get());
    List<String> types =
        Arrays.asList(StandardCharsets.ISO_8859_1.decode(answer).toString().split(",", -1));
    List<String> unknown = new ArrayList<>();
    for (int i = 0; i < Math.min(types.size(), names.size()); i++) {
      if (types.get(i).equals(NOT_FOUND)) {
        unknown.add(names.get(i));
      }
    }
    if (!unknown.isEmpty()) {
      return new Subscription.Unknown(unknown);
    }
    if (types.size() != names.size() || recipe == 0) {
      throw new IOException(withReason("refusesFields", "refusesFieldsBecause"));
    }
    List<ReceivedField> fields = new ArrayList<>();
    dataBytes = 1;
    for (int i = 0; i < types.size(); i++) {
      FieldType type = type(names.get(i), types.get(i));
      fields.add(new ReceivedField(names.get(i), type));
      dataBytes += type.bytes();
    }
    return new Subscription.Granted(fields);
  }

  private static FieldType type(String field, String type) throws IOException {
    return Arrays.stream(FieldType.values())
        .filter(each -> each.name().equals(type))
        .findFirst()
        .orElseThrow(() -> new IOException(text("unknownFieldType", field, type)));
  }

  /**
   * Lets the fields come that were granted.
   *
   * @throws IOException if the controller refuses or the connection is lost
   */
  public void start() throws IOException {
    if (!accepted(ask(PacketType.START, ReplyCodec.packet(PacketType.START, 0).array()))) {
      throw new IOException(withReason("refusesToStart", "refusesToStartBecause"));
    }
  }

  /**
   * The next data: the values of all fields, one after the other as {@link ReceivedField} says.
   *
   * @return empty when none have come for a tenth of a second
   * @throws EOFException when the controller has closed the connection
   * @throws IOException if what comes is no RTDE, or not the fields that were granted
   */
  public Optional<ByteBuffer> next() throws IOException {
    long endNs = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(WAIT_MS);
    do {
      Optional<Packet> packet = packet();
      if (packet.isPresent() && packet.get().type() == PacketType.DATA) {
        ByteBuffer data = packet.get().payload();
        if (data.remaining() != dataBytes || Byte.toUnsignedInt(data.get(0)) != recipe) {
          throw new IOException(text("dataOfWrongLength", data.remaining(), dataBytes - 1));
        }
        data.get();
        return Optional.of(data);
      }
      packet.ifPresent(this::listen);
    } while (System.nanoTime() < endNs);
    return Optional.empty();
  }

  /** Sends a request and waits for its answer. */
  private ByteBuffer ask(int type, byte[] request) throws IOException {
    socket.getOutputStream().write(request);
    long endNs = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(ANSWER_MS);
    while (System.nanoTime() < endNs) {
      Optional<Packet> packet = packet();
      if (packet.isPresent() && packet.get().type() == type) {
        return packet.get().payload();
      }
      packet.ifPresent(this::listen);
    }
    throw new SocketTimeoutException(text("noAnswerWithin", ANSWER_MS / 1000));
  }

  /**
   * Has no fields come any more, until {@link #start}.
   *
   * @throws IOException if the controller refuses or the connection is lost
   */
  void pause() throws IOException {
    if (!accepted(ask(PacketType.PAUSE, ReplyCodec.packet(PacketType.PAUSE, 0).array()))) {
      throw new IOException(withReason("refusesToPause", "refusesToPauseBecause"));
    }
  }

  /**
   * Takes inputs, which only this client may write then.
   *
   * @return the number of the recipe, and the types of the inputs
   * @throws IOException if the controller refuses the wish, or the connection is lost
   */
  InputsGranted takeInputs(List<String> names) throws IOException {
    byte[] text = String.join(",", names).getBytes(StandardCharsets.ISO_8859_1);
    byte[] request = ReplyCodec.packet(PacketType.SETUP_INPUTS, text.length).put(text).array();
    ByteBuffer answer = ask(PacketType.SETUP_INPUTS, request);
    if (!answer.hasRemaining()) {
      throw new IOException(text("inputsAnswerEmpty"));
    }
    int number = Byte.toUnsignedInt(answer.get());
    String[] types = StandardCharsets.ISO_8859_1.decode(answer).toString().split(",", -1);
    List<FieldType> granted = new ArrayList<>();
    for (int i = 0; i < Math.min(types.length, names.size()); i++) {
      switch (types[i]) {
        case NOT_FOUND -> throw new IOException(text("noSuchInput", names.get(i)));
        case "IN_USE" -> throw new IOException(text("inputOfAnotherClient", names.get(i)));
        default -> granted.add(type(names.get(i), types[i]));
      }
    }
    if (granted.size() != names.size() || number == 0) {
      throw new IOException(withReason("refusesInputs", "refusesInputsBecause"));
    }
    return new InputsGranted(number, granted);
  }

  /**
   * Inputs that this client may write.
   *
   * @param number of their recipe
   */
  record InputsGranted(int number, List<FieldType> types) {
    InputsGranted {
      types = List.copyOf(types);
    }
  }

  /** Sends a data package. */
  void send(byte[] packet) throws IOException {
    socket.getOutputStream().write(packet);
  }

  private static boolean accepted(ByteBuffer answer) {
    return answer.hasRemaining() && answer.get() != 0;
  }

  /** The next whole package; empty when none comes within {@link #WAIT_MS}. */
  private Optional<Packet> packet() throws IOException {
    try {
      Optional<Packet> packet = cutter.next(unread);
      if (packet.isPresent()) {
        return packet;
      }
      int count = socket.getInputStream().read(buffer);
      if (count < 0) {
        throw new EOFException(withReason("hasClosed", "hasClosedBecause"));
      }
      unread = ByteBuffer.wrap(buffer, 0, count);
      return cutter.next(unread);
    } catch (SocketTimeoutException e) {
      return Optional.empty();
    } catch (ProtocolException e) {
      throw new IOException(text("notRtde", e.getMessage()), e);
    }
  }

  /** Keeps what the controller says: it explains refusals so. */
  private void listen(Packet packet) {
    if (packet.type() == PacketType.TEXT_MESSAGE
        && RequestCodec.decode(packet, VERSION) instanceof RtdeRequest.Text text) {
      said = Optional.of(text.text());
    }
  }

  private String withReason(String plain, String withReason) {
    return said.map(reason -> text(withReason, reason)).orElseGet(() -> text(plain));
  }

  private static String hex(ByteBuffer bytes) {
    StringBuilder text = new StringBuilder();
    while (bytes.hasRemaining()) {
      text.append(Integer.toHexString(Byte.toUnsignedInt(bytes.get()))).append(' ');
    }
    return text.toString().strip();
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
