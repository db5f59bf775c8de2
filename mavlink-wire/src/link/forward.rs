//! What a link does by its halves: said once for [`Link`](super::Link) and for its twin for async tasks.

/// Gives `Link` these methods of a half, with the end of their docs. `[async await]` stands in front of one that waits in a task.
macro_rules! forward {
    ($self:ident.$field:ident: $half:ident, $docs:literal {
        $(
            $(#[$meta:meta])*
            $([$async:ident $await:ident])?
            fn $name:ident$(<$generic:ident>)?(&$($receiver:ident)+ $(, $argument:ident: $type:ty)*) $(-> $result:ty)?;
        )+
    }) => {
        impl Link {
            $(
                #[doc = concat!("See [`", stringify!($half), "::", stringify!($name), "`].", $docs)]
                $(#[$meta])*
                pub $($async)? fn $name$(<$generic>)?(&$($receiver)+ $(, $argument: $type)*) $(-> $result)? {
                    $self.$field.$name($($argument),*)$(.$await)?
                }
            )+
        }
    };
}

/// The methods of both halves, with `async await` for those of async tasks.
macro_rules! forward_to_halves {
    ($($async:ident $await:ident)?) => {
        $crate::link::forward::forward! { self.receiving: ReceiveHalf, "\n\n# Errors\n\nSee there." {
            $([$async $await])? fn receive(&mut self) -> Result<Frame<'_>, LinkError>;
            $([$async $await])? fn receive_until(&mut self, deadline: Instant) -> Result<Option<Frame<'_>>, LinkError>;
            $([$async $await])? fn receive_from(&mut self, deadline: Instant) -> Result<Option<(Frame<'_>, Peer)>, LinkError>;
        } }
        $crate::link::forward::forward! { self.receiving: ReceiveHalf, "" {
            #[must_use] fn statistics(&self) -> LinkStatistics;
            #[cfg(feature = "signing")] fn verifier(&mut self) -> Option<&mut Verifier>;
            #[cfg(feature = "signing")] fn set_verifier(&mut self, verifier: Option<Verifier>);
        } }
        $crate::link::forward::forward! { self.sending: SendHalf, "\n\n# Errors\n\nSee there." {
            $([$async $await])? fn send(&self, message: &(impl Encode + ?Sized)) -> Result<usize, LinkError>;
            $([$async $await])? fn queue(&self, message: &(impl Encode + ?Sized)) -> Result<usize, LinkError>;
            $([$async $await])? fn flush(&self) -> Result<(), LinkError>;
            $([$async $await])? fn send_to(&self, message: &(impl Encode + ?Sized), peer: Peer) -> Result<(), LinkError>;
            $([$async $await])? fn send_frame(&self, frame: &Frame<'_>) -> Result<usize, LinkError>;
            $([$async $await])? fn send_frame_to(&self, frame: &Frame<'_>, peer: Peer) -> Result<(), LinkError>;
        } }
        $crate::link::forward::forward! { self.sending: SendHalf, "" {
            #[must_use] fn system_id(&self) -> SystemId;
            #[must_use] fn component_id(&self) -> ComponentId;
            fn with_sender<R>(&self, change: impl FnOnce(&mut Sender) -> R) -> R;
            #[must_use] fn peers(&self) -> Vec<Peer>;
            fn remove_peer(&self, peer: Peer) -> bool;
            #[must_use] fn is_connected(&self) -> bool;
            #[must_use] fn trouble(&self) -> Option<String>;
            #[must_use] fn local_addr(&self) -> Option<SocketAddr>;
            fn close(&self);
        } }
    };
}

pub(crate) use forward;
pub(super) use forward_to_halves;
