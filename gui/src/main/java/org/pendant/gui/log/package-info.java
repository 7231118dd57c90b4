/**
 * The screen of the controller's messages: kept, filtered, searched, copied and exported. Open
 * {@link org.pendant.gui.log.LogPresenter} first.
 */
package org.pendant.gui.log;
