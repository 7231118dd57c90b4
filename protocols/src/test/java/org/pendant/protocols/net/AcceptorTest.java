package org.pendant.protocols.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import org.junit.jupiter.api.Test;

class AcceptorTest {
  private final Queue<String> coming = new ArrayDeque<>();
  private final List<String> greeted = new ArrayList<>();
  private final List<Duration> waits = new ArrayList<>();
  private final List<String> logged = new ArrayList<>();

  /** Peers by their names; a blank one is the system that has no file left. */
  private final Acceptor.Door<String> door =
      new Acceptor.Door<>() {
        @Override
        public boolean open() {
          return !coming.isEmpty();
        }

        @Override
        public String accept() throws IOException {
          String next = coming.remove();
          if (next.isBlank()) {
            throw new IOException("Too many open files");
          }
          return next;
        }

        @Override
        public void greet(String peer) throws IOException {
          if (peer.equals("gone")) {
            throw new IOException("connection reset");
          }
          greeted.add(peer);
        }
      };

  private void accept(String... peers) {
    coming.addAll(List.of(peers));
    coming.add("last");
    new Acceptor<>("Echo", door, waits::add, new PeerLog((level, text) -> logged.add(text))).run();
  }

  @Test
  void waitsLongerEachTimeWhileFilesHaveRunOut() {
    accept("", "", "", "one");
    assertEquals(
        List.of(Duration.ofMillis(10), Duration.ofMillis(20), Duration.ofMillis(40)), waits);
    assertEquals(List.of("one", "last"), greeted);
  }

  @Test
  void neverWaitsLongerThanASecond() {
    accept(" ".repeat(20).split("(?<=.)"));
    assertTrue(waits.stream().allMatch(each -> each.compareTo(Duration.ofSeconds(1)) <= 0));
    assertEquals(Duration.ofSeconds(1), waits.getLast());
  }

  @Test
  void saysOnceThatFilesHaveRunOutAndOnceThatItGoesOn() {
    accept("", "", "", "one", "two");
    assertEquals(
        List.of(
            "Echo: no connection can be taken, it is tried again: Too many open files",
            "Echo: connections are taken again"),
        logged);
  }

  @Test
  void beginsWithTheShortestWaitWhenFilesRunOutAgain() {
    accept("", "", "one", "");
    assertEquals(
        List.of(Duration.ofMillis(10), Duration.ofMillis(20), Duration.ofMillis(10)), waits);
  }

  @Test
  void aPeerThatIsGoneAlreadyKeepsNobodyWaiting() {
    accept("gone", "one");
    assertEquals(List.of(), waits);
    assertEquals(List.of("one", "last"), greeted);
    assertEquals(List.of("Echo: a connection failed: connection reset"), logged);
  }
}
