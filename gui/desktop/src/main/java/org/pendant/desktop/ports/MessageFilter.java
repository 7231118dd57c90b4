package org.pendant.desktop.ports;

import java.util.Locale;
import java.util.Optional;
import org.pendant.protocols.trace.Peers;
import org.pendant.protocols.trace.WireMessage;
import org.pendant.protocols.wire.Direction;

/**
 * Message filter: which messages people want to see.
 *
 * @param text stands in what is shown of a message, upper and lower case alike; empty for all
 * @param client only of this one; empty for all
 * @param direction only this one; empty for both
 * @param effects only those that do something
 * @param streamed also those that come at a rate
 */
record MessageFilter(
    String text,
    Optional<Peers> client,
    Optional<Direction> direction,
    boolean effects,
    boolean streamed) {
  /** All but those that come at a rate. */
  static final MessageFilter USUAL =
      new MessageFilter("", Optional.empty(), Optional.empty(), false, false);

  MessageFilter withText(String wanted) {
    return new MessageFilter(wanted, client, direction, effects, streamed);
  }

  MessageFilter withClient(Optional<Peers> wanted) {
    return new MessageFilter(text, wanted, direction, effects, streamed);
  }

  MessageFilter withDirection(Optional<Direction> wanted) {
    return new MessageFilter(text, client, wanted, effects, streamed);
  }

  MessageFilter withEffects(boolean only) {
    return new MessageFilter(text, client, direction, only, streamed);
  }

  MessageFilter withStreamed(boolean too) {
    return new MessageFilter(text, client, direction, effects, too);
  }

  /** Whether a message is wanted. */
  boolean wants(WireMessage message) {
    return (streamed || !message.streamed())
        && (!effects || message.reading().effect().isPresent())
        && direction.filter(each -> each != message.direction()).isEmpty()
        && client.filter(each -> !each.equals(message.peers())).isEmpty()
        && hasText(message);
  }

  private boolean hasText(WireMessage message) {
    String wanted = text.strip().toLowerCase(Locale.ROOT);
    return wanted.isEmpty()
        || MessageWords.summary(message.reading()).toLowerCase(Locale.ROOT).contains(wanted)
        || MessageWords.line(message.reading()).toLowerCase(Locale.ROOT).contains(wanted)
        || message.reading().type().contains(wanted)
        || message.peers().port().toLowerCase(Locale.ROOT).contains(wanted)
        || message.peers().client().contains(wanted);
  }
}
