package org.pendant.protocols.modbus;

/** Refused request, answered by one of the protocol's exceptions. */
final class RefusedRequest extends Exception {
  private static final long serialVersionUID = 1L;

  /** Why, with the number that goes over the wire. */
  enum Reason {
    /** The server does not know the function. */
    FUNCTION(1),
    /** There is no such register or bit, or it can only be read. */
    ADDRESS(2),
    /** A number of registers, a value or a length that cannot be. */
    VALUE(3),
    /** The box refuses the change, for instance because another client has taken the signal. */
    FAILURE(4);

    private final int number;

    Reason(int number) {
      this.number = number;
    }

    int number() {
      return number;
    }
  }

  private final Reason reason;

  RefusedRequest(Reason reason) {
    // thrown for every wrong request of a peer: no message, no stack
    super(reason.name(), null, false, false);
    this.reason = reason;
  }

  Reason reason() {
    return reason;
  }
}
