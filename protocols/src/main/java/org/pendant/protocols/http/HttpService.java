package org.pendant.protocols.http;

/**
 * HTTP service: answers requests; those of one client come one after the other, in a thread of its
 * own.
 */
@FunctionalInterface
public interface HttpService {
  /** The answer to a request; may wait. */
  HttpReply answer(HttpCall call) throws InterruptedException;

  /** How large the body of a request may be. */
  default BodyLimit bodyLimit(String method, String path) {
    return BodyLimit.USUAL;
  }
}
