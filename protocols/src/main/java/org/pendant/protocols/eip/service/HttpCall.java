package org.pendant.protocols.eip.service;

import java.nio.ByteBuffer;

/**
 * One request by HTTP.
 *
 * @param method such as {@code POST}
 * @param keep whether the connection stays for another one
 */
record HttpCall(String method, boolean keep, ByteBuffer body) {}
