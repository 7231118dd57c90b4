package org.pendant.protocols.eip;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.protocols.net.ProtocolException;

class EncapsulationReaderTest {
  /** Command, length, session, status, context, options, data. */
  private static final String REGISTER =
      "6500 0400 00000000 00000000 0102030405060708 00000000 0100 0000";

  private static final String NOP = "0000 0000 00000000 00000000 0000000000000000 00000000";

  private static List<String> cut(EncapsulationReader cutter, byte[]... pieces)
      throws ProtocolException {
    List<String> frames = new ArrayList<>();
    for (byte[] piece : pieces) {
      ByteBuffer bytes = ByteBuffer.wrap(piece);
      for (Optional<EncapsulationFrame> next = cutter.next(bytes);
          next.isPresent();
          next = cutter.next(bytes)) {
        frames.add(Hex.text(next.get().encode()));
      }
    }
    return frames;
  }

  private static String plain(String hex) {
    return hex.replace(" ", "");
  }

  @Test
  void takesFramesThatAreCutAnywhere() throws ProtocolException {
    byte[] all = Hex.bytes(REGISTER + NOP + REGISTER);
    List<String> expected = List.of(plain(REGISTER), plain(NOP), plain(REGISTER));
    for (int cut = 0; cut <= all.length; cut++) {
      byte[] begin = new byte[cut];
      byte[] end = new byte[all.length - cut];
      System.arraycopy(all, 0, begin, 0, cut);
      System.arraycopy(all, cut, end, 0, end.length);
      assertEquals(expected, cut(new EncapsulationReader(), begin, end), "cut at " + cut);
    }
  }

  @Test
  void knowsTheFieldsOfAFrame() throws ProtocolException {
    EncapsulationFrame frame = new EncapsulationReader().next(Hex.buffer(REGISTER)).orElseThrow();
    assertEquals(Encapsulation.REGISTER_SESSION, frame.command());
    assertEquals(0x0807060504030201L, frame.context());
    assertEquals("01000000", Hex.text(frame.data()));
  }

  @Test
  void refusesAnAbsurdLength() {
    assertThrows(
        ProtocolException.class,
        () -> new EncapsulationReader().next(Hex.buffer("6F00 0110 0000")));
  }

  @Test
  void takesTheLongestFrame() throws ProtocolException {
    byte[] longest = new byte[EncapsulationFrame.HEADER + EncapsulationFrame.MAX_DATA];
    longest[3] = 0x10;
    assertEquals(List.of(Hex.text(longest)), cut(new EncapsulationReader(), longest));
  }
}
