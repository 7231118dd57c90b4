package org.pendant.protocols.http;

import java.util.concurrent.Semaphore;

/** Large bodies: how many of them are kept at once by a server. Any thread may use it. */
public final class LargeBodies {
  private final Semaphore places;

  /**
   * No body is kept yet.
   *
   * @param most at once
   */
  public LargeBodies(int most) {
    places = new Semaphore(most);
  }

  /** Takes a place; answers whether there was one. */
  boolean take() {
    return places.tryAcquire();
  }

  /** Gives a place back. */
  void give() {
    places.release();
  }
}
