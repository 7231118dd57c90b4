package org.pendant.protocols.net;

import java.net.InetAddress;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * Connection slots: the places of one port. When all are taken, a newcomer gets the place of
 * whoever is silent for longest, so that peers that only hold their places shut no other out; peers
 * of the address that holds most places go first. Some places are kept for this computer itself.
 * Any thread.
 */
final class ConnectionSlots<C extends Occupant> {
  /** One place of so many is for this computer only. */
  private static final int RESERVED_OF = 16;

  /** Who has said something keeps its place for this long. */
  static final long SPOKEN_KEEPS_NS = TimeUnit.SECONDS.toNanos(60);

  private final int most;
  private final Set<C> occupants = new LinkedHashSet<>();

  /**
   * What becomes of a newcomer.
   *
   * @param taken whether it has a place
   * @param givenUp whose place it has got
   */
  record Admission<C>(boolean taken, Optional<C> givenUp) {}

  /**
   * All free.
   *
   * @param most how many there are
   */
  ConnectionSlots(int most) {
    this.most = most;
  }

  /** Gives a newcomer a place, unless all others are in use. */
  synchronized Admission<C> admit(C newcomer, long nowNs) {
    boolean full = occupants.size() >= most;
    boolean remoteFull = !local(newcomer) && remote() >= most - most / RESERVED_OF;
    if (!full && !remoteFull) {
      occupants.add(newcomer);
      return new Admission<>(true, Optional.empty());
    }
    Optional<C> silent = mostSilent(remoteFull, nowNs);
    if (silent.isPresent()) {
      occupants.remove(silent.get());
      occupants.add(newcomer);
    }
    return new Admission<>(silent.isPresent(), silent);
  }

  private Optional<C> mostSilent(boolean onlyRemote, long nowNs) {
    Map<InetAddress, Long> places =
        occupants.stream().collect(Collectors.groupingBy(Occupant::address, Collectors.counting()));
    Map<C, Silence> silences =
        occupants.stream()
            .filter(each -> !onlyRemote || !local(each))
            .collect(Collectors.toMap(Function.identity(), each -> each.silence(nowNs)));
    return silences.keySet().stream()
        .filter(each -> mayBeGivenUp(silences.get(each)))
        .min(
            Comparator.comparing((C each) -> places.get(each.address()), Comparator.reverseOrder())
                .thenComparing(each -> silences.get(each).kind())
                .thenComparing(each -> silences.get(each).lastsNs(), Comparator.reverseOrder()));
  }

  private static boolean mayBeGivenUp(Silence silence) {
    return silence.kind() != Silence.Kind.SPOKEN || silence.lastsNs() > SPOKEN_KEEPS_NS;
  }

  private long remote() {
    return occupants.stream().filter(each -> !local(each)).count();
  }

  private static boolean local(Occupant each) {
    return each.address().isLoopbackAddress();
  }

  /** The place of {@code occupant} is free again. */
  synchronized void free(C occupant) {
    occupants.remove(occupant);
  }

  /** Who has a place now, in the order in which they came. */
  synchronized List<C> occupants() {
    return List.copyOf(occupants);
  }
}
