package org.pendant.protocols.hostile;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;

/** What is spoken at a port, as far as a client must know it to speak it wrongly. */
final class Dialect {
  private static final Dialect MODBUS =
      new Dialect(
          "Modbus",
          List.of(
              hex("0001 0000 0006 01 03 010E 0006"),
              hex("0002 0000 0006 01 01 0010 0008"),
              hex("0003 0000 0006 01 06 0080 04D2"),
              hex("0004 0000 0006 01 05 0010 FF00"),
              hex("0005 0000 000B 01 10 0080 0002 04 0001 0002"),
              hex("0006 0000 0008 01 16 0084 00F2 0025"),
              hex("0007 0000 000D 01 17 0080 0002 0081 0001 02 0007")),
          hex("0009 0000 0006 01 03 0080 0001"),
          4,
          6);

  private static final Dialect RTDE =
      new Dialect(
          "RTDE",
          List.of(
              rtde('V', hex("0002")),
              rtde('v', new byte[0]),
              rtde('O', hex("407F400000000000"), latin("timestamp,actual_q,robot_mode")),
              rtde('O', hex("4059000000000000"), latin("timestamp,no_such_field,")),
              rtde('I', latin("input_int_register_24,input_double_register_24")),
              rtde('I', latin("speed_slider_mask,speed_slider_fraction")),
              rtde('U', hex("01 00000007 3FE0000000000000")),
              rtde('S', new byte[0]),
              rtde('P', new byte[0]),
              rtde('M', hex("05"), latin("Hello"), hex("04"), latin("RTDE"), hex("03"))),
          rtde('V', hex("0002")),
          0,
          3);

  private static final Dialect DASHBOARD =
      new Dialect(
          "Dashboard",
          lines(
              "robotmode",
              "programState",
              "safetystatus",
              "power on",
              "power off",
              "brake release",
              "play",
              "stop",
              "pause",
              "load nothing.urp",
              "load ../../../etc/passwd",
              "popup hello",
              "close popup",
              "addToLog hello",
              "set operational mode manual",
              "set operational mode automatic",
              "clear operational mode",
              "get loaded program",
              "unlock protective stop",
              "is in remote control",
              "PolyscopeVersion"),
          latin("robotmode\n"));

  private static final Dialect INTERPRETER =
      new Dialect(
          "Interpreter",
          lines(
              "a = 1",
              "sleep(0.002)",
              "set_digital_out(0, True)",
              "foo(",
              "def f(): return 1 end",
              "statelastexecuted",
              "stateunexecuted",
              "skipbuffer",
              "abort",
              "clear_interpreter()",
              "end_interpreter()"),
          latin("stateunexecuted\n"));

  private static final Dialect SCRIPT =
      new Dialect(
          "",
          lines(
              "def ends():\n  a = [1, 2, 3]\n  textmsg(\"a is \", a)\nend",
              "def stays():\n  while True:\n    sync()\n  end\nend",
              "def moves():\n  movej([0.1, -1.5, 1.5, -1.5, -1.5, 0], a=1.4, v=1.05)\nend",
              "def listens():\n  interpreter_mode()\nend",
              "sec beside():\n  set_digital_out(1, True)\nend",
              "sec wrong():\n  sleep(1)\nend",
              "set_digital_out(2, True)",
              "speedl([0, 0, 0.01, 0, 0, 0], 0.5, 0.1)",
              "def unfinished():\n  if True:",
              "power on",
              "stop program",
              "set robotmode run",
              "set speed 0.5"),
          latin("\n"));

  private static final Dialect ETHERNET_IP =
      new Dialect(
          "EtherNet/IP",
          List.of(
              eip(0x65, hex("01000000")),
              eip(0x04),
              eip(0x63),
              eip(0x66),
              eip(0x6F, hex("00000000 0000 0200 0000 0000 B200 0800 0E03200124013001")),
              eip(
                  0x6F,
                  hex("00000000 0000 0200 0000 0000 B200 3000 5402200624010A0E"),
                  hex("00000000 01000700 0100 3412 CDAB0000 00 000000 204E0000 E648"),
                  hex("204E0000 E249 01 04 200424012C702C64"))),
          eip(0x63),
          2,
          24);

  private static final Dialect FIELDBUS =
      new Dialect(
          "Fieldbus",
          List.of(
              call("<methodName>is_instance_connected</methodName>"),
              call("<methodName>add_configuration</methodName>"),
              latin("GET /RPC2 HTTP/1.1\r\n\r\n"),
              latin("POST / HTTP/1.1\r\nContent-Length: 65537\r\n\r\n"),
              latin("POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n")),
          latin("GET / HTTP/1.1\r\n\r\n"));

  private static final Dialect ROBOT_API =
      new Dialect(
          "Robot API",
          List.of(
              put("/robotstate/v1/state", "{\"action\":\"POWER_ON\"}"),
              put("/robotstate/v1/state", "{\"action\":\"UNLOCK_PROTECTIVE_STOP\"}"),
              put("/program/v1/state", "{\"action\":\"play\"}"),
              put("/program/v1/loaded", "{\"name\":\"nothing\"}"),
              latin("GET /universal-robots/robot-api/programs/v1 HTTP/1.1\r\n\r\n"),
              latin("GET /universal-robots/robot-api/openapi.json HTTP/1.0\r\n\r\n"),
              latin("PUT / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n")),
          latin("GET / HTTP/1.1\r\n\r\n"));

  /** The last one is for every port that has none of its own. */
  private static final List<Dialect> ALL =
      List.of(MODBUS, RTDE, DASHBOARD, INTERPRETER, ETHERNET_IP, FIELDBUS, ROBOT_API, SCRIPT);

  private final String port;

  private final List<byte[]> samples;
  private final byte[] question;
  private final int lengthAt;
  private final int header;

  /**
   * A protocol of frames.
   *
   * @param port how the names of its ports begin
   * @param lengthAt where two bytes tell the length
   * @param header bytes that a frame has at least
   */
  private Dialect(String port, List<byte[]> samples, byte[] question, int lengthAt, int header) {
    this.port = port;
    this.samples = samples;
    this.question = question;
    this.lengthAt = lengthAt;
    this.header = header;
  }

  /** A protocol of lines. */
  private Dialect(String port, List<byte[]> samples, byte[] question) {
    this(port, samples, question, 0, 0);
  }

  /** The dialect of the port with this name. */
  static Dialect of(String name) {
    return ALL.stream().filter(each -> name.startsWith(each.port)).findFirst().orElseThrow();
  }

  private boolean framed() {
    return header > 0;
  }

  /** What a port answers, if only by continuing to send. */
  byte[] question() {
    return question.clone();
  }

  /** Something after which the next frame can still be found. */
  byte[] withinFrame(Random random) {
    byte[] packet = sample(random);
    int from = framed() ? header : 0;
    if (packet.length > from && random.nextInt(4) != 0) {
      for (int i = random.nextInt(1, 4); i > 0; i--) {
        packet[random.nextInt(from, packet.length)] = (byte) random.nextInt(256);
      }
    }
    return packet;
  }

  /** Anything. */
  byte[] anything(Random random) {
    byte[] packet = sample(random);
    return switch (random.nextInt(5)) {
      // cut short
      case 0 -> Arrays.copyOf(packet, random.nextInt(packet.length));
      // the length is not true
      case 1 -> {
        if (framed()) {
          ByteBuffer.wrap(packet).putShort(lengthAt, (short) random.nextInt(1 << 16));
        }
        yield packet;
      }
      // far too long, or a line that does not end
      case 2 -> {
        byte[] noise = noise(random, random.nextInt(1, 1 << 16));
        for (int at = 0; !framed() && at < noise.length; at++) {
          noise[at] = noise[at] == '\n' ? 0 : noise[at];
        }
        yield noise;
      }
      case 3 -> noise(random, random.nextInt(1, 64));
      default -> {
        packet[random.nextInt(packet.length)] ^= (byte) (1 << random.nextInt(8));
        yield packet;
      }
    };
  }

  private byte[] sample(Random random) {
    return samples.get(random.nextInt(samples.size())).clone();
  }

  private static byte[] noise(Random random, int length) {
    byte[] noise = new byte[length];
    random.nextBytes(noise);
    return noise;
  }

  private static byte[] hex(String text) {
    return HexFormat.of().parseHex(text.replace(" ", ""));
  }

  private static byte[] latin(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  private static List<byte[]> lines(String... lines) {
    return Arrays.stream(lines).map(line -> latin(line + "\n")).toList();
  }

  private static byte[] eip(int command, byte[]... parts) {
    byte[] content = joined(parts);
    byte[] header =
        ByteBuffer.allocate(24)
            .order(ByteOrder.LITTLE_ENDIAN)
            .putShort((short) command)
            .putShort((short) content.length)
            .putInt(command == 0x6F ? 1 : 0)
            .array();
    return joined(header, content);
  }

  private static byte[] put(String path, String body) {
    return latin(
        "PUT /universal-robots/robot-api"
            + path
            + " HTTP/1.1\r\nContent-Length: "
            + body.length()
            + "\r\n\r\n"
            + body);
  }

  private static byte[] call(String xml) {
    String body = "<methodCall>" + xml + "</methodCall>";
    return latin("POST /RPC2 HTTP/1.1\r\nContent-Length: " + body.length() + "\r\n\r\n" + body);
  }

  private static byte[] rtde(char type, byte[]... parts) {
    byte[] content = joined(parts);
    return joined(
        ByteBuffer.allocate(3).putShort((short) (content.length + 3)).put((byte) type).array(),
        content);
  }

  private static byte[] joined(byte[]... parts) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (byte[] part : parts) {
      all.writeBytes(part);
    }
    return all.toByteArray();
  }
}
