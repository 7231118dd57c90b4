package org.pendant.protocols.modbus;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.protocols.net.ProtocolException;

class ModbusFrameReaderTest {
  private static final byte[] READ = Hex.bytes("0001 0000 0006 01 03 010E 0006");
  private static final byte[] SHORTEST = Hex.bytes("0002 0000 0002 01 07");

  private final ModbusFrameReader cutter = new ModbusFrameReader();

  private List<byte[]> feed(byte[] bytes) throws ProtocolException {
    ByteBuffer buffer = ByteBuffer.wrap(bytes);
    List<byte[]> frames = new ArrayList<>();
    for (Optional<byte[]> frame = cutter.next(buffer);
        frame.isPresent();
        frame = cutter.next(buffer)) {
      frames.add(frame.get());
    }
    assertEquals(0, buffer.remaining());
    return frames;
  }

  @Test
  void putsARequestTogetherThatIsCutAnywhere() throws Exception {
    for (int cut = 1; cut < READ.length; cut++) {
      assertTrue(feed(Arrays.copyOf(READ, cut)).isEmpty());
      List<byte[]> frames = feed(Arrays.copyOfRange(READ, cut, READ.length));
      assertEquals(1, frames.size(), "cut at " + cut);
      assertArrayEquals(READ, frames.getFirst());
    }
  }

  @Test
  void findsSeveralRequestsInOneGo() throws Exception {
    byte[] both = Arrays.copyOf(READ, READ.length + SHORTEST.length);
    System.arraycopy(SHORTEST, 0, both, READ.length, SHORTEST.length);
    List<byte[]> frames = feed(both);
    assertEquals(2, frames.size());
    assertArrayEquals(READ, frames.get(0));
    assertArrayEquals(SHORTEST, frames.get(1));
  }

  @ParameterizedTest
  @ValueSource(strings = {"0000", "0001", "00FF", "7FFF", "FFFF"})
  void refusesLengthsThatNoRequestHas(String length) {
    byte[] prefix = Hex.bytes("0001 0000 " + length);
    ProtocolException refusal = assertThrows(ProtocolException.class, () -> feed(prefix));
    assertEquals(
        "the length is " + Integer.parseInt(length, 16) + ", must be 2 to 254",
        refusal.getMessage());
  }

  @Test
  void takesTheLongestRequest() throws Exception {
    byte[] frame = new byte[ModbusFrameReader.PREFIX + ModbusFrameReader.MAX_REST];
    frame[5] = (byte) ModbusFrameReader.MAX_REST;
    assertEquals(1, feed(frame).size());
  }

  @Test
  void findsTheSameRequestsHoweverTheyAreCut() throws Exception {
    long seed = 40_502;
    Random random = new Random(seed);
    for (int round = 0; round < 200; round++) {
      List<byte[]> sent = new ArrayList<>();
      ByteArrayOutputStream stream = new ByteArrayOutputStream();
      for (int i = random.nextInt(1, 20); i > 0; i--) {
        int rest = random.nextInt(ModbusFrameReader.MIN_REST, ModbusFrameReader.MAX_REST + 1);
        byte[] frame = new byte[ModbusFrameReader.PREFIX + rest];
        random.nextBytes(frame);
        frame[4] = 0;
        frame[5] = (byte) rest;
        sent.add(frame);
        stream.writeBytes(frame);
      }
      List<byte[]> found = new ArrayList<>();
      byte[] all = stream.toByteArray();
      for (int begin = 0; begin < all.length; ) {
        int end = Math.min(all.length, begin + random.nextInt(1, 400));
        found.addAll(feed(Arrays.copyOfRange(all, begin, end)));
        begin = end;
      }
      assertEquals(sent.size(), found.size(), "seed " + seed + ", round " + round);
      for (int i = 0; i < sent.size(); i++) {
        assertArrayEquals(sent.get(i), found.get(i), "seed " + seed + ", round " + round);
      }
    }
  }
}
