package org.pendant.controller.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(30)
class ReceivedBytesTest {

  @Test
  void givesInOrderWhatCameThroughManyTurnsOfItsRing() throws Exception {
    ReceivedBytes bytes = new ReceivedBytes();
    int count = 5 * ReceivedBytes.CAPACITY + 123;
    FutureTask<Boolean> sender =
        new FutureTask<>(
            () -> {
              byte[] part = new byte[1000];
              for (int sent = 0; sent < count; sent += part.length) {
                int size = Math.min(part.length, count - sent);
                for (int i = 0; i < size; i++) {
                  part[i] = (byte) (sent + i);
                }
                bytes.append(part, size);
              }
              bytes.end();
              return true;
            });
    Thread.ofVirtual().start(sender);
    int taken = 0;
    while (taken < count) {
      int length = bytes.length();
      for (int i = 0; i < length; i++) {
        assertEquals((taken + i) & 0xFF, bytes.byteAt(i));
      }
      bytes.skip(length);
      taken += length;
    }
    assertTrue(sender.get());
    assertTrue(bytes.ended());
  }

  @Test
  void whoWaitsForRoomIsLetGoWhenNobodyTakesMore() throws InterruptedException, ExecutionException {
    ReceivedBytes bytes = new ReceivedBytes();
    FutureTask<Boolean> sender =
        new FutureTask<>(
            () -> bytes.append(new byte[ReceivedBytes.CAPACITY + 1], ReceivedBytes.CAPACITY + 1));
    Thread.ofVirtual().start(sender);
    while (bytes.length() < ReceivedBytes.CAPACITY) {
      Thread.onSpinWait();
    }
    bytes.abandon();
    assertFalse(sender.get());
    assertTrue(bytes.ended());
  }
}
