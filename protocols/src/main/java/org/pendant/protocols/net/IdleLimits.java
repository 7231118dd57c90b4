package org.pendant.protocols.net;

import static org.pendant.protocols.net.NetTexts.text;

import java.time.Duration;
import java.util.Optional;

/**
 * Idle limits: how long a peer may say nothing before it is disconnected, according to its
 * protocol.
 *
 * @param firstWord after connecting; empty where peers may only listen
 * @param afterwards between what it says; empty where peers may stay as long as they like
 */
public record IdleLimits(Optional<Duration> firstWord, Optional<Duration> afterwards) {
  /** Of a protocol whose peers may be silent for ever. */
  public static final IdleLimits NONE = new IdleLimits(Optional.empty(), Optional.empty());

  private static final Duration FIRST_WORD = Duration.ofSeconds(60);

  /** Of a protocol in which the peer begins, and may then be silent for as long as it likes. */
  public static IdleLimits peerBegins() {
    return new IdleLimits(Optional.of(FIRST_WORD), Optional.empty());
  }

  /** Of a protocol in which a peer connects to ask at once, and leaves. */
  public static IdleLimits of(Duration each) {
    return new IdleLimits(Optional.of(each), Optional.of(each));
  }

  /** Why a peer is silent for too long; empty if it is not. */
  Optional<String> exceeded(Silence silence) {
    Optional<Duration> limit =
        switch (silence.kind()) {
          case NEVER_SPOKEN -> firstWord;
          case SPOKEN -> afterwards;
          case NOT_READING -> Optional.empty();
        };
    return limit
        .filter(most -> silence.lastsNs() > most.toNanos())
        .map(most -> text("hasSaidNothing", most.toSeconds()));
  }
}
