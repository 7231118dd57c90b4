/**
 * Log screen: the controller's messages, kept, filtered, searched, copied and exported. Open {@link
 * org.pendant.desktop.log.LogPresenter} first.
 */
package org.pendant.desktop.log;
