package org.pendant.fuzz;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;

/**
 * What can be said at a port, in an order that makes sense.
 *
 * @param port how the names of its ports begin; blank for all others
 * @param messages a conversation, of which any begin makes sense as well
 * @param question something that the port answers, if only by continuing to send
 */
record Vocabulary(String port, List<byte[]> messages, List<byte[]> question) {
  private static final List<Vocabulary> ALL =
      List.of(
          new Vocabulary(
              "RTDE",
              List.of(
                  rtde('V', hex("0002")),
                  rtde('v'),
                  rtde('O', hex("407F400000000000"), latin("timestamp,actual_q,robot_mode")),
                  rtde('I', latin("input_int_register_24,input_double_register_24")),
                  rtde('I', latin("speed_slider_mask,speed_slider_fraction")),
                  rtde('S'),
                  rtde('U', hex("01 00000007 3FE0000000000000")),
                  rtde('U', hex("02 00000001 3FE0000000000000")),
                  rtde('M', hex("05"), latin("Hello"), hex("04"), latin("fuzz"), hex("03")),
                  rtde('P'),
                  rtde('O', hex("4059000000000000"), latin("timestamp,no_such_field")),
                  rtde('S')),
              List.of(rtde('V', hex("0002")))),
          new Vocabulary(
              "Modbus",
              List.of(
                  hex("0001 0000 0006 01 03 010E 0006"),
                  hex("0002 0000 0006 01 01 0010 0008"),
                  hex("0003 0000 0006 01 06 0080 04D2"),
                  hex("0004 0000 0006 01 05 0010 FF00"),
                  hex("0005 0000 000B 01 10 0080 0002 04 0001 0002"),
                  hex("0006 0000 0008 01 16 0084 00F2 0025"),
                  hex("0007 0000 000D 01 17 0080 0002 0081 0001 02 0007")),
              List.of(hex("0009 0000 0006 01 03 0080 0001"))),
          new Vocabulary(
              "Dashboard",
              lines(
                  "robotmode",
                  "power on",
                  "brake release",
                  "programState",
                  "load nothing.urp",
                  "load ../../../etc/passwd",
                  "play",
                  "pause",
                  "stop",
                  "popup hello",
                  "close popup",
                  "addToLog hello",
                  "set operational mode manual",
                  "clear operational mode",
                  "safetystatus",
                  "unlock protective stop",
                  "is in remote control",
                  "PolyscopeVersion",
                  "power off",
                  "quit"),
              List.of(latin("robotmode\n"))),
          new Vocabulary(
              "Interpreter",
              lines(
                  "statelastexecuted",
                  "a = 1",
                  "set_digital_out(0, True)",
                  "def f(): return 1 end",
                  "foo(",
                  "stateunexecuted",
                  "skipbuffer",
                  "abort",
                  "clear_interpreter()",
                  "end_interpreter()"),
              List.of(latin("stateunexecuted\n"))),
          new Vocabulary(
              "EtherNet/IP",
              List.of(
                  eip(0x65, hex("01000000")),
                  eip(0x63),
                  eip(0x04),
                  eip(0x6F, hex("00000000 0000 0200 0000 0000 B200 0800 0E03200124013001")),
                  eip(
                      0x6F,
                      hex("00000000 0000 0200 0000 0000 B200 3000 5402200624010A0E"),
                      hex("00000000 01000700 0100 3412 CDAB0000 00 000000 204E0000 E648"),
                      hex("204E0000 E249 01 04 200424012C702C64")),
                  eip(0x6F, hex("00000000 0000 0200 0000 0000 B200 0800 0E03200424643003")),
                  eip(0x66)),
              List.of(eip(0x63))),
          new Vocabulary(
              "Fieldbus",
              List.of(
                  call("<methodName>is_instance_connected</methodName>"),
                  call(
                      "<methodName>is_instance_connected</methodName><params><param><value><i4>112"
                          + "</i4></value></param></params>"),
                  latin("POST /RPC2 HTTP/1.1\r\nContent-Length: 65537\r\n\r\n"),
                  latin("GET /RPC2 HTTP/1.1\r\n\r\n")),
              List.of(latin("GET / HTTP/1.1\r\n\r\n"))),
          new Vocabulary(
              "",
              lines(
                  "power on",
                  "set robotmode run",
                  "def ends():\n  a = [1, 2, 3]\n  textmsg(\"a is \", a)\nend",
                  "def stays():\n  while True:\n    sync()\n  end\nend",
                  "sec beside():\n  set_digital_out(1, True)\nend",
                  "def moves():\n  movej([0.1, -1.5, 1.5, -1.5, -1.5, 0], a=1.4, v=1.05)\nend",
                  "sec wrong():\n  sleep(1)\nend",
                  "def listens():\n  interpreter_mode()\nend",
                  "set_digital_out(2, True)",
                  "speedl([0, 0, 0.01, 0, 0, 0], 0.5, 0.1)",
                  "set speed 0.5",
                  "request_value 3 12.5",
                  "stop program",
                  "def unfinished():\n  if True:"),
              List.of(latin("\n"))));

  /** What is spoken at the port with this name. */
  static Vocabulary of(String name) {
    return ALL.stream().filter(each -> name.startsWith(each.port)).findFirst().orElseThrow();
  }

  /** Whether what is said carries the number of the session, as the port has given it. */
  boolean numbered() {
    return port.equals("EtherNet/IP");
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

  private static byte[] rtde(char type, byte[]... parts) {
    byte[] content = joined(parts);
    return joined(
        ByteBuffer.allocate(3).putShort((short) (content.length + 3)).put((byte) type).array(),
        content);
  }

  private static byte[] eip(int command, byte[]... parts) {
    byte[] content = joined(parts);
    byte[] header =
        ByteBuffer.allocate(24)
            .order(ByteOrder.LITTLE_ENDIAN)
            .putShort((short) command)
            .putShort((short) content.length)
            .array();
    return joined(header, content);
  }

  private static byte[] call(String xml) {
    String body = "<methodCall>" + xml + "</methodCall>";
    return latin("POST /RPC2 HTTP/1.1\r\nContent-Length: " + body.length() + "\r\n\r\n" + body);
  }

  private static byte[] joined(byte[]... parts) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (byte[] part : parts) {
      all.writeBytes(part);
    }
    return all.toByteArray();
  }
}
