/**
 * The outside world's doors to a controller: each protocol that a control box speaks gets a package
 * of its own below this one, split into messages, framing and session. Nothing is here yet but the
 * place; the controller declares the interfaces that these packages will implement, so start
 * reading at {@code org.pendant.controller.Controller}.
 */
package org.pendant.protocols;
