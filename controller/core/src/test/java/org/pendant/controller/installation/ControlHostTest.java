package org.pendant.controller.installation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ControlHostTest {

  @ParameterizedTest
  @CsvSource({
    "192.168.0.7, 192.168.0.7, 50002",
    "pc.local:50012, pc.local, 50012",
    "::1, ::1, 50002",
    "fe80::1%eth0, fe80::1%eth0, 50002",
    "[::1]:50012, ::1, 50012",
    "[::1], ::1, 50002",
  })
  void isReadAsPeopleWriteIt(String text, String host, int port) {
    ControlHost parsed = ControlHost.parse(text);
    assertEquals(new ControlHost(host, port), parsed);
    assertEquals(parsed, ControlHost.parse(parsed.text()));
  }

  @ParameterizedTest
  @CsvSource({
    "'', '\"\" is no host, must be HOST or HOST:PORT, as 192.168.56.1:50002'",
    "pc:, '\"pc:\" is no host, must be HOST or HOST:PORT, as 192.168.56.1:50002'",
    "pc:fast, '\"pc:fast\" is no host, must be HOST or HOST:PORT, as 192.168.56.1:50002'",
    "pc:0, 'the port is 0, must be 1 to 65535'",
    "pc:65536, 'the port is 65536, must be 1 to 65535'",
    "my pc:50002, 'the host is \"my pc\", must be the name or address of a computer'",
  })
  void refusesWhatIsNoHost(String text, String message) {
    assertEquals(
        message,
        assertThrows(IllegalArgumentException.class, () -> ControlHost.parse(text)).getMessage());
  }

  @Test
  void isThatOfTheUrcapUnlessItIsToldAnother() {
    assertEquals("192.168.56.1:50002", Installation.NONE.controlHost().text());
  }
}
