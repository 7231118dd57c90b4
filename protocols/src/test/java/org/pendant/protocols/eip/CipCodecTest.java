package org.pendant.protocols.eip;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CipCodecTest {
  private static final long SEED = 20_261_122;

  /** Times, ids, name, multiplier, intervals and sizes, transport, path. */
  private static final String OPEN =
      "0A 0E 00000000 01000100 0100 3412 CDAB0000 03 000000 204E0000 E648 204E0000 E249 01"
          + " 04 2004 2401 2C70 2C64";

  private static final String LARGE_OPEN =
      "0A 0E 00000000 01000100 0100 3412 CDAB0000 03 000000 204E0000 E6000048 204E0000 E2010048"
          + " 01 04 2004 2401 2C70 2C64";

  private static ByteBuffer part(String hex, int length) {
    return ByteBuffer.wrap(Hex.bytes(hex), 0, length).slice().order(ByteOrder.LITTLE_ENDIAN);
  }

  private static int length(String hex) {
    return Hex.bytes(hex).length;
  }

  @Test
  void readsAForwardOpen() throws CipRefusal {
    assertOpen(OpenRequest.decode(Hex.buffer(OPEN), false));
  }

  @Test
  void readsALargeForwardOpen() throws CipRefusal {
    assertOpen(OpenRequest.decode(Hex.buffer(LARGE_OPEN), true));
  }

  private static void assertOpen(OpenRequest open) {
    assertEquals(0x00010001, open.toOriginatorId());
    assertEquals(new ConnectionName(1, 0x1234, 0xABCD), open.name());
    assertEquals(20_000, open.toTargetUs());
    assertEquals(20_000L * 1000 * 32, open.timeoutNs());
    assertEquals(
        new ConnectionParameters(230, false, ConnectionParameters.Type.POINT_TO_POINT),
        open.toTarget());
    assertEquals(
        new ConnectionParameters(482, false, ConnectionParameters.Type.POINT_TO_POINT),
        open.toOriginator());
    assertEquals(1, open.transportClass());
    assertEquals(List.of(1, 112, 100), open.path().instances());
  }

  @Test
  void refusesAForwardOpenOfAnyOtherLength() {
    for (int i = 0; i < length(OPEN); i++) {
      ByteBuffer bytes = part(OPEN, i);
      assertThrows(CipRefusal.class, () -> OpenRequest.decode(bytes, false));
    }
    for (int i = 0; i < length(LARGE_OPEN); i++) {
      ByteBuffer bytes = part(LARGE_OPEN, i);
      assertThrows(CipRefusal.class, () -> OpenRequest.decode(bytes, true));
    }
    assertEquals(
        CipRefusal.TOO_LONG,
        assertThrows(CipRefusal.class, () -> OpenRequest.decode(Hex.buffer(OPEN + "00"), false))
            .status());
  }

  @Test
  void readsEverySegmentOfAPath() throws CipRefusal {
    CipPath path =
        CipPath.decode(
            Hex.buffer(
                "0100 1203 31323300 34 04 7705 2B00 0100 85 18 2100 0401 2500 F401 2C70 2D00 6500"
                    + " 3103 0500 8002 AABBCCDD"));
    assertEquals(
        new CipPath(
            Optional.of(new ElectronicKey(1399, 43, 1, true, 5, 24)),
            OptionalInt.of(0x104),
            List.of(500, 112, 101),
            OptionalInt.of(5),
            4),
        path);
  }

  @ParameterizedTest
  @CsvSource({
    "20",
    "2100 04",
    "34 05 00",
    "34 04 0000",
    "80 02 AA",
    "91 01 41",
    "0F 01",
    "12 09 31"
  })
  void refusesSegmentsThatAreCutOffOrUnknown(String hex) {
    assertEquals(
        CipRefusal.PATH_SEGMENT,
        assertThrows(CipRefusal.class, () -> CipPath.decode(Hex.buffer(hex))).status());
  }

  @Test
  void anythingIsAPathOrRefused() {
    Random random = new Random(SEED);
    for (int i = 0; i < 20_000; i++) {
      byte[] noise = new byte[random.nextInt(40)];
      random.nextBytes(noise);
      decodeAnything(ByteBuffer.wrap(noise).order(ByteOrder.LITTLE_ENDIAN));
    }
  }

  /** Fails by any other exception. */
  private static void decodeAnything(ByteBuffer bytes) {
    try {
      CipPath.decode(bytes);
    } catch (CipRefusal e) {
      assertEquals(CipRefusal.PATH_SEGMENT, e.status());
    }
  }

  @Test
  void anyChangeOfAForwardOpenIsAnotherOneOrRefused() {
    Random random = new Random(SEED);
    for (int i = 0; i < 20_000; i++) {
      byte[] bytes = Hex.bytes(OPEN);
      for (int j = random.nextInt(1, 4); j > 0; j--) {
        bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
      }
      try {
        OpenRequest.decode(ByteBuffer.wrap(bytes), false);
      } catch (CipRefusal e) {
        assertEquals(true, e.status() > 0);
      }
    }
  }

  @Test
  void readsItemsAndRefusesEveryOtherLength() {
    String items = "0200 0000 0000 B200 0600 0E0320042464";
    List<PacketItem> read = PacketItem.decode(Hex.buffer(items)).orElseThrow();
    assertEquals(2, read.size());
    assertEquals("0E0320042464", Hex.text(read.get(1).data()));
    for (int i = 0; i < length(items); i++) {
      assertEquals(Optional.empty(), PacketItem.decode(part(items, i)), "cut at " + i);
    }
    assertEquals(Optional.empty(), PacketItem.decode(Hex.buffer(items + "00")));
    assertEquals(Optional.empty(), PacketItem.decode(Hex.buffer("FFFF 0000 0000")));
    assertEquals(Optional.empty(), PacketItem.decode(Hex.buffer("0100 B200 FFFF 00")));
  }

  @Test
  void cyclicPacketsGoThereAndBack() {
    String hex = "0200 0280 0800 01000100 02000000 B100 0600 0300 AABBCCDD";
    IoPacket packet = IoPacket.decode(Hex.buffer(hex)).orElseThrow();
    assertEquals(0x10001, packet.connection());
    assertEquals(2, packet.number());
    assertEquals(3, packet.dataNumber());
    assertEquals("AABBCCDD", Hex.text(packet.data()));
    assertEquals(hex.replace(" ", ""), Hex.text(packet.encode()));
    for (int i = 0; i < length(hex); i++) {
      assertEquals(Optional.empty(), IoPacket.decode(part(hex, i)), "cut at " + i);
    }
    assertEquals(Optional.empty(), IoPacket.decode(Hex.buffer(hex + "00")));
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0, 0, false, 0, 0, ''",
    "1399, 43, 1, false, 5, 24, ''",
    "1399, 43, 1, true, 5, 3, ''",
    "1, 0, 0, false, 0, 0, WRONG_VENDOR_OR_PRODUCT",
    "1399, 0, 7, false, 0, 0, WRONG_VENDOR_OR_PRODUCT",
    "0, 12, 0, false, 0, 0, WRONG_DEVICE_TYPE",
    "0, 0, 0, false, 4, 0, WRONG_REVISION",
    "0, 0, 0, false, 5, 3, WRONG_REVISION",
    "0, 0, 0, true, 5, 25, WRONG_REVISION"
  })
  void aKeyFitsOrNot(
      int vendor, int type, int product, boolean compatible, int major, int minor, String fault) {
    assertEquals(
        fault,
        new ElectronicKey(vendor, type, product, compatible, major, minor)
            .mismatch(DeviceIdentity.OWN)
            .map(ConnectionFault::name)
            .orElse(""));
  }
}
